#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/files/junit.h"
#include "pipeline/commands/commands.h"
#include "pipeline/input/identity_cache.h"
#include "pipeline/reports/check.h"
#include "scene/package/output_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

struct CheckOptions {
    std::vector<std::string> files;
    std::string junit;
    CheckDepth depth;
    bool rehash = false;
};

struct Checked {
    std::string file;
    std::vector<Issue> issues;
    double seconds;
};

/// The input folder of a package: the given folder itself for a single package, otherwise its subfolder with
/// the package's name.
fs::path inputs_of(const CheckOptions& o, const fs::path& file) {
    if (o.depth.against.empty() || o.files.size() == 1) return o.depth.against;
    return o.depth.against / file.stem();
}

Checked check_one(const CheckOptions& o, IdentityCache& identities, const std::string& file) {
    CheckDepth depth = o.depth;
    depth.against = inputs_of(o, file);
    depth.identities = &identities;
    const auto start = std::chrono::steady_clock::now();
    std::vector<Issue> issues = check_package(file, depth);
    return {file, std::move(issues),
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

std::string all_text(const std::vector<Issue>& issues) {
    std::string text;
    for (const Issue& i : issues)
        text += fmt::format("{}[{}] {}", text.empty() ? "" : "\n", i.row().id, i.text);
    return text;
}

void print_lines(const Checked& c, bool deep) {
    for (const Issue& i : c.issues)
        fmt::print(text_output(), "{}: {} [{}]: {}\n", c.file, kind_name(i.row()), i.row().id, i.text);
    if (c.issues.empty()) fmt::print(text_output(), "{}: valid{}\n", c.file, deep ? ", every tile read" : "");
    std::fflush(text_output());
}

nlohmann::json json_of(const std::vector<Checked>& all) {
    nlohmann::json out = nlohmann::json::array();
    for (const Checked& c : all) {
        nlohmann::json issues = nlohmann::json::array();
        for (const Issue& i : c.issues)
            issues.push_back({{"id", i.row().id},
                              {"severity", severity_name(i.row().severity)},
                              {"kind", kind_name(i.row())},
                              {"text", i.text}});
        out.push_back(
            {{"file", c.file}, {"valid", c.issues.empty()}, {"issues", issues}, {"seconds", c.seconds}});
    }
    return out;
}

int run_check(const CheckOptions& o) {
    if (!o.junit.empty())
        output_file(o.junit, Product::junit, {{o.files.begin(), o.files.end()}, {}}, std::nullopt);
    IdentityCache identities(default_identity_cache(), o.rehash);
    std::vector<Checked> all;
    std::vector<Issue> issues;
    std::vector<CheckCase> cases;
    for (const std::string& file : o.files) {
        const Checked& c = all.emplace_back(check_one(o, identities, file));
        issues.insert(issues.end(), c.issues.begin(), c.issues.end());
        const Exit kind = worst(c.issues);
        const auto first =
            std::ranges::find_if(c.issues, [&](const Issue& i) { return i.row().kind == kind; });
        cases.push_back(
            {file, first == c.issues.end() ? "" : kind_name(first->row()), all_text(c.issues), c.seconds});
        print_lines(c, o.depth.deep);
    }
    results()["packages"] = json_of(all);
    if (!o.junit.empty()) write_junit(o.junit, "vantage check", cases);
    return int(worst(issues));
}

}  // namespace

void add_check(const Command& program) {
    auto o = std::make_shared<CheckOptions>();
    const Command c = program.verb(
        "check",
        "Check packages, and the stories beside them, for damage, changed inputs and missing photos");
    c.notes(
        "Examples:\n  vantage check chapel.vantage\n"
        "  vantage check --deep --against scans/chapel chapel.vantage\n"
        "  vantage check collection/*.vantage --against scans --junit checks.xml   (collection/a.vantage "
        "against "
        "scans/a)\n"
        "Exit code, that of the worst package: 3 unreadable, 4 damaged, 5 stale, 9 incomplete, 0 none of "
        "these.\nEach finding has a stable identifier.");
    c.list("FILES", o->files, "the packages, or their URLs").type("PACKAGE").required();
    c.flag("--deep", o->depth.deep, "read every tile");
    c.file("--against", o->depth.against,
           "compare with this input folder or, for several packages, with its subfolders of the same names")
        .type("FOLDER");
    c.flag("--rehash", o->rehash, "detect changed inputs by content, not by size and timestamps");
    c.file("--junit", o->junit, "write a JUnit file for CI");
    c.action([o] { return run_check(*o); });
}

}  // namespace vantage
