#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/progress_option.h"
#include "pipeline/commands/shared/skipped_photos.h"
#include "pipeline/output/staleness.h"
#include "pipeline/prepare/merge_packages.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

struct MergeOptions {
    std::vector<std::string> shares;
    std::string out;
    ProgressStyle progress = ProgressStyle::automatic;
    bool remove = false, force = false;
};

/// The shards and their inputs.
Inputs inputs_of_shares(const std::vector<std::string>& shares) {
    Inputs out{{shares.begin(), shares.end()}, {}};
    try {
        out.contents = inputs_of(PackageReader(shares.front(), PackageReader::Expect::part)).contents;
    } catch (const Error&) {  // not a shard: merge() reports it
    }
    return out;
}

int run_merge(MergeOptions o) {
    o.out = output_file(o.out, Product::package, inputs_of_shares(o.shares), o.force).string();
    {
        ProgressLine line(o.progress);
        merge({o.shares.begin(), o.shares.end()}, o.out, shown_until_signal(line));
    }
    if (o.remove)
        for (const std::string& share : o.shares) std::filesystem::remove(share);
    const std::uintmax_t bytes = std::filesystem::file_size(o.out);
    fmt::print(text_output(), "package  {} ({:.1f} MB from {} shards)\n", o.out, double(bytes) / 1e6,
               o.shares.size());
    results().update({{"package", o.out}, {"bytes", bytes}});
    return int(report_skipped(skipped_of(PackageReader(o.out))));
}

}  // namespace

void add_merge(const Command& program) {
    auto o = std::make_shared<MergeOptions>();
    const Command c = program.verb("merge", "Join the shards of a preparation into one package");
    c.notes(
        "Each shard is written by 'vantage prepare INPUT -o SHARD --shard i/n', on any machine. The result "
        "is\n"
        "byte-for-byte identical to the package that a single run writes. An interrupted merge resumes when "
        "it is run again.\n"
        "Example:\n  vantage merge chapel-*.shard -o chapel.vantage --remove");
    c.list("SHARDS", o->shares, "all shards of one preparation, in any order").type("FILE").required();
    c.file("-o,--output", o->out, "the package to write").required();
    add_progress(c, o->progress);
    c.force(o->force);
    c.flag("--remove", o->remove, "remove the shards when the package is complete");
    c.action([o] { return run_merge(*o); });
}

}  // namespace vantage
