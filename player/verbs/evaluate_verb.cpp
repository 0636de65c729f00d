#include <algorithm>

#include "player/measure/evaluation/evaluate.h"
#include "player/options/shown/opened_package.h"
#include "player/verbs/verbs.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

/// Throws Error(usage) if the evaluation would overwrite anything but an earlier evaluation.
void expect_evaluation_folder(const PackageReader& package, const EvaluateOptions& o) {
    const Inputs inputs = inputs_of(package);
    expect_result_folder(o.folder, "index.html", Product::page, {"photos.csv", "regions.csv", "regions.ply"},
                         inputs, o.output.force);
    // Pictures are named after their photos.
    const std::vector<std::string> stems = package.photo_stems();
    const auto for_photo = [&](const std::string& name) {
        return std::ranges::any_of(stems, [&](const auto& stem) { return name.starts_with(stem + "-"); });
    };
    expect_result_pictures(o.folder, for_photo, inputs, o.output.force);
}

int evaluate(EvaluateOptions o) {
    if (!o.output.file.empty()) o.folder = o.output.file;
    const PackageReader package = opened_package(o.package.file, o.memory);
    expect_evaluation_folder(package, o);
    return run_evaluate(package, o);
}

}  // namespace

void add_evaluate(const Command& program) {
    const auto o = std::make_shared<EvaluateOptions>();
    const Command c = program.verb("evaluate", "Compare each photo with a prediction from the others");
    add_package_argument(c, o->package).required();
    add_exclude_option(c, o->package);
    add_photo_option(c, o->package, "photos to hold out, or 'all'");
    add_output_options(c, o->output);
    add_memory_options(c, o->memory);
    add_blending_options(c, o->blending);
    add_blended_option(c, o->blending);
    const std::string group = "Evaluation";
    c.integer("--level", o->level, 0, 8, "pyramid level to compare: 0 is full size, 1 half size")
        .group(group);
    c.integer("--every", o->every, 1, 1 << 20, "hold out only every n-th photo (or those of --photo)")
        .group(group);
    c.integer("--worst", o->worst, 0, 1 << 20, "number of worst photos to show first").group(group);
    c.file("--against", o->against,
           "folder of an earlier evaluation; shows the changes per photo, and their worst and best regions")
        .type("FOLDER")
        .group(group);
    c.notes(
        "Writes index.html, photos.csv, regions.csv, regions.ply and pictures into the folder given by -o "
        "(default\n"
        "evaluation).\n"
        "Columns computed over the colored pixels: PSNR and SSIM, each before and after the best gain per "
        "channel.\n"
        "Columns computed over the whole frame as in the window, including holes: PSNR and SSIM after that "
        "gain.\n"
        "The other columns: dB gained over the nearest photo alone; percentage of the photo's surface that "
        "the others\n"
        "color; stops by which the photo is brighter than the others; offset of its content to the right "
        "and down,\n"
        "in px at full size; energy of the finest detail relative to the photo's.\n"
        "A second table divides the squared error by cause. It shows each cause's fraction of the error of "
        "the whole\n"
        "frame and of the colored pixels, and the dB that would be gained without that cause "
        "(docs/method.md).\n"
        "Examples:\n"
        "  vantage-player evaluate chapel.vantage\n"
        "  vantage-player evaluate chapel.vantage --every 10 --level 2 -o quick\n"
        "  vantage-player evaluate chapel.vantage --blend average --photo 0003 0007\n"
        "  vantage-player evaluate chapel.vantage --original-colors -o before\n"
        "  vantage-player evaluate chapel.vantage -o after --against before");
    c.action([o] { return evaluate(*o); });
}

}  // namespace vantage
