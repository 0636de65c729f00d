#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/text/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/reports/diff.h"

namespace vantage {
namespace {

struct DiffOptions {
    std::string a, b, folder;
    bool force = false;
};

void print(const std::vector<Difference>& all) {
    for (const Difference& d : all)
        fmt::print(text_output(), "{}{}{}: {}\n", d.of, d.what.empty() ? "" : ": ", d.what, d.text);
    if (all.empty()) fmt::print(text_output(), "identical\n");
}

nlohmann::json json_of(const std::vector<Difference>& all) {
    nlohmann::json out = nlohmann::json::array();
    for (const Difference& d : all) out.push_back({{"of", d.of}, {"what", d.what}, {"text", d.text}});
    return out;
}

int run_diff(const DiffOptions& o) {
    const PackageReader a(o.a), b(o.b);
    if (!o.folder.empty()) expect_replaceable(a, b, o.folder, o.force);
    const std::vector<Difference> all = diff(a, b);
    const std::filesystem::path page =
        o.folder.empty() ? std::filesystem::path() : write_difference_page(a, b, all, o.folder);
    print(all);
    results()["differences"] = json_of(all);
    if (!page.empty()) {
        fmt::print(text_output(), "{}\n", page.string());
        results()["page"] = page.string();
    }
    return int(all.empty() ? Exit::ok : Exit::different);
}

}  // namespace

void add_diff(const Command& program) {
    auto o = std::make_shared<DiffOptions>();
    const Command c = program.verb("diff", "List the differences between two packages, artifact by artifact");
    c.notes(
        "Examples:\n  vantage diff chapel.vantage chapel-new.vantage\n"
        "  vantage diff a.vantage b.vantage -o differences   (as a page, with pictures)\n"
        "Exit code: 0 identical, 10 different.");
    c.file("A", o->a, "a package").type("PACKAGE").required();
    c.file("B", o->b, "the package to compare A with").type("PACKAGE").required();
    c.file("-o,--output", o->folder, "folder for an HTML page of the differences, with pictures")
        .type("FOLDER");
    c.force(o->force);
    c.action([o] { return run_diff(*o); });
}

}  // namespace vantage
