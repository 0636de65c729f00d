#include "pipeline/check.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "pipeline/commands/commands.h"

namespace vantage {
namespace {

struct Options {
    std::string file, against;
    bool deep = false, json = false;
};

int run_check(const Options& o) {
    const std::vector<Issue> issues = check_package(o.file, o.deep, o.against);
    Exit worst = Exit::ok;
    for (const Issue& i : issues) worst = worst == Exit::damaged ? worst : i.kind;
    if (o.json) {
        nlohmann::json out{{"file", o.file}, {"sound", issues.empty()}, {"issues", nlohmann::json::array()}};
        for (const Issue& i : issues)
            out["issues"].push_back(
                {{"kind", i.kind == Exit::stale ? "stale" : "damaged"}, {"text", i.text}});
        fmt::print("{}\n", out.dump(1));
    } else {
        for (const Issue& i : issues)
            fmt::print("{}: {}: {}\n", o.file, i.kind == Exit::stale ? "stale" : "damaged", i.text);
        if (issues.empty()) fmt::print("{}: sound{}\n", o.file, o.deep ? ", every tile read" : "");
    }
    return int(worst);
}

}  // namespace

void add_check(CLI::App& app, Run& run) {
    auto o = std::make_shared<Options>();
    CLI::App* c = app.add_subcommand("check", "Check that a package is whole, sound and current");
    c->footer(
        "Examples:\n  vantage check chapel.vantage\n  vantage check --deep --against scans/chapel "
        "chapel.vantage");
    c->add_option("FILE", o->file, "the package")->required();
    c->add_flag("--deep", o->deep, "read every tile");
    c->add_option("--against", o->against, "the input folder it was prepared from");
    c->add_flag("--json", o->json, "machine-readable output");
    c->callback([o, &run] { run = [o] { return run_check(*o); }; });
}

}  // namespace vantage
