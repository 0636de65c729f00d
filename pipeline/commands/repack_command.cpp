#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "base/cli/standard_output.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/progress_option.h"
#include "pipeline/prepare/repack_package.h"
#include "scene/package/contents/effects.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

struct RepackOptions {
    std::string file, out;
    ProgressStyle progress = ProgressStyle::automatic;
    bool compact = true, force = false;
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
        ProgressLine line(o.progress);
        repack(o.file, o.compact, out, shown_until_signal(line));
    }
    const std::uint64_t bytes = PackageReader(out).size();
    fmt::print(text_output(), "package  {} ({:.1f} MB, previously {:.1f} MB)\n", out, double(bytes) / 1e6,
               double(before) / 1e6);
    results().update({{"package", out}, {"bytes", bytes}, {"bytes_before", before}});
    return 0;
}

}  // namespace

void add_repack(const Command& program) {
    auto o = std::make_shared<RepackOptions>();
    const Command c = program.verb("repack", "Write a package with its tiles compressed or raw");
    c.notes(
        "Needs only the package. The result contains the photos' original JPEG data only if 'vantage "
        "prepare'\n"
        "stored it; raw tiles are compressed to high-quality JPEG.\n"
        "Examples:\n  vantage repack chapel.vantage -o small.vantage\n"
        "  vantage repack chapel.vantage -o chapel-raw.vantage --tiles raw");
    c.file("FILE", o->file, "the package").type("PACKAGE").required();
    c.file("-o,--output", o->out, "the package to write").required();
    c.choice("--tiles", o->compact, {{"jpeg", true}, {"raw", false}},
             "jpeg: about 10 times smaller, decoded on display; raw: uncompressed");
    c.force(o->force);
    add_progress(c, o->progress);
    c.action([o] { return run_repack(*o); });
}

}  // namespace vantage
