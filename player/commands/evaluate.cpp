#include "player/evaluate/evaluate.h"

#include <algorithm>

#include "output/output_file.h"
#include "output/package_inputs.h"
#include "player/commands/commands.h"
#include "player/commands/parse.h"
#include "player/options/opened_package.h"

namespace vantage {

void add_evaluate_options(CLI::App& app, EvaluateOptions& o, UnusedOptions& unused) {
    add_package_options(app, o.package);
    add_output_options(app, o.output);
    add_memory_options(app, o.memory);
    add_blending_options(app, o.blending);
    add_unused_options(app, unused);
    hide(app, {"--size", "--quiet", "--upload", "--transparency"});
    const std::string group = "Evaluation";
    app.add_option("--level", o.level, "pyramid level to compare: 0 full size, 1 half size")
        ->check(CLI::Range(0, 8))
        ->capture_default_str()
        ->group(group);
    app.add_option("--every", o.every, "leave out only every n-th photo (or those of --photo)")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str()
        ->group(group);
    app.add_option("--worst", o.worst, "number of worst photos to show first")
        ->check(CLI::Range(0, 1 << 20))
        ->capture_default_str()
        ->group(group);
    app.add_option("--against", o.against,
                   "folder of an earlier evaluation: shows what has changed per photo, and where most")
        ->type_name("FOLDER")
        ->group(group);
    app.footer(
        "Writes index.html, photos.csv, regions.csv, regions.ply and pictures into the folder given by -o "
        "(default\n"
        "evaluation).\n"
        "Columns, over the colored pixels: PSNR and SSIM, each before and after the best gain per channel. "
        "Over the\n"
        "whole frame as the window shows it, holes included: PSNR and SSIM after that gain. Then: dB above "
        "the nearest\n"
        "photo alone; percent of the photo's surface that the others color; stops brighter than the others; "
        "offset of\n"
        "the photo's content to the right and down, px at full size; energy of the finest detail relative "
        "to the photo's.\n"
        "A second table divides the squared error by cause: share of the whole frame's error and of that at "
        "colored\n"
        "pixels, each with the dB that would be gained without it (docs/method.md).\n"
        "Examples:\n"
        "  vantage-player evaluate chapel.vantage\n"
        "  vantage-player evaluate chapel.vantage --every 10 --level 2 -o quick\n"
        "  vantage-player evaluate chapel.vantage --blend average --photo 0003 0007\n"
        "  vantage-player evaluate chapel.vantage --original-colors -o before\n"
        "  vantage-player evaluate chapel.vantage -o after --against before");
}

namespace {

/// Throws Error(usage) if the evaluation would overwrite anything but an earlier one.
void expect_evaluation_folder(const PackageReader& package, const EvaluateOptions& o) {
    const Inputs inputs = inputs_of(package);
    expect_result_folder(o.folder, "index.html", Product::page, {"photos.csv", "regions.csv", "regions.ply"},
                         inputs, o.output.force);
    // Pictures are named for their photos.
    const std::vector<std::string> stems = package.photo_stems();
    const auto for_photo = [&](const std::string& name) {
        return std::ranges::any_of(stems, [&](const auto& stem) { return name.starts_with(stem + "-"); });
    };
    expect_result_pictures(o.folder, for_photo, inputs, o.output.force);
}

}  // namespace

int evaluate_command(int argc, char** argv) {
    CLI::App app{
        "vantage-player evaluate leaves out each photo in turn and compares it with the picture that the "
        "others give."};
    EvaluateOptions options;
    UnusedOptions unused;
    add_evaluate_options(app, options, unused);
    if (const auto code = parse(app, argc, argv)) return *code;
    if (!options.output.file.empty()) options.folder = options.output.file;
    const PackageReader package = opened_package(options.package.file, options.memory, options.output.quiet);
    expect_evaluation_folder(package, options);
    return run_evaluate(package, options);
}

}  // namespace vantage
