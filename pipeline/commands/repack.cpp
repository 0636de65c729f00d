#include "pipeline/prepare/repack.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "cli/force_option.h"
#include "output/output_file.h"
#include "output/package_inputs.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/progress_line.h"
#include "scene/effects.h"
#include "scene/package_reader.h"

namespace vantage {
namespace {

struct RepackOptions {
    std::string file, out, tiles = "jpeg", progress = "auto";
    bool force = false;
};

int run_repack(const RepackOptions& o) {
    std::uint64_t before = 0;
    std::string out;
    {
        const PackageReader package(o.file);
        before = package.size();
        Inputs inputs = inputs_of(package);
        inputs.files.emplace_back(o.file);
        out = output_file(o.out, Product::package, inputs, o.force).string();
    }
    {
        ProgressLine line(progress_style(o.progress));
        repack(o.file, o.tiles == "jpeg", out, shown_until_signal(line));
    }
    fmt::print("package  {} ({:.1f} MB, before {:.1f} MB)\n", out, double(PackageReader(out).size()) / 1e6,
               double(before) / 1e6);
    return 0;
}

}  // namespace

void add_repack(CLI::App& app, Run& run) {
    auto o = std::make_shared<RepackOptions>();
    CLI::App* c = app.add_subcommand("repack", "Write a package again with its tiles in another form");
    c->footer(
        "Needs only the package. A photo's own JPEG is in a package only if 'vantage prepare' put it there; "
        "raw tiles become JPEG of high quality.\n"
        "Examples:\n  vantage repack chapel.vantage -o small.vantage\n"
        "  vantage repack chapel.vantage -o chapel-raw.vantage --tiles raw");
    c->add_option("FILE", o->file, "the package")->type_name("PACKAGE")->required();
    c->add_option("-o,--output", o->out, "the package to write")->type_name("FILE")->required();
    c->add_option("--tiles", o->tiles,
                  "jpeg: some 10 times shorter, decoded while shown; raw: as they are shown")
        ->check(CLI::IsMember({"raw", "jpeg"}))
        ->capture_default_str();
    add_force(*c, o->force);
    add_progress(*c, o->progress);
    c->callback([o, &run] { run = [o] { return run_repack(*o); }; });
}

}  // namespace vantage
