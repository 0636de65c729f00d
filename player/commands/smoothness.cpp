#include "player/measure/smoothness.h"

#include "cli/real_range.h"
#include "output/output_file.h"
#include "output/package_inputs.h"
#include "player/commands/commands.h"
#include "player/commands/parse.h"
#include "player/options/opened_package.h"

namespace vantage {

void add_smoothness_options(CLI::App& app, SmoothnessOptions& o) {
    add_package_options(app, o.package);
    add_output_options(app, o.output);
    add_memory_options(app, o.memory);
    add_blending_options(app, o.blending);
    hide(app, {"--quiet", "--upload", "--transparency"});
    const std::string group = "Smoothness";
    app.add_option(
           "--path", o.path,
           "file of views to fly along (default: through the photos' cameras, or those of --photo, from "
           "each to the nearest that is left)")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--step", o.step, "degrees that the camera turns or moves around its target per frame")
        ->check(real_range(0.01, 90.0))
        ->capture_default_str()
        ->group(group);
    app.add_flag("!--no-fading", o.fades, "photos appear and disappear at once; for comparison")
        ->group(group);
    app.add_option("--worst", o.worst, "number of steps to save as PNG, the largest first")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str()
        ->group(group);
    app.footer(
        "Each frame is drawn as in the window (640x360 by default, 30 per second, 4 photos), every tile in "
        "place, and again\nwith the photos and weights of the next frame: the difference is how far the "
        "color "
        "of a surface jumps, without any\nmovement. It is averaged in cells of 1/40 of the picture's width. "
        "Printed: the mean of a picture's cells, and what its\nworst hundredth exceeds, each over the frames "
        "and per degree of movement.\n"
        "Writes steps.csv, summary.json, steps.svg and the worst steps as step-FRAME.png (the frame, the "
        "same "
        "with the next\none's weights, eight times the difference) into the folder given by -o (default "
        "smoothness).\n"
        "Examples:\n"
        "  vantage-player smoothness chapel.vantage\n"
        "  vantage-player smoothness chapel.vantage --original-colors -o as-taken\n"
        "  vantage-player smoothness chapel.vantage --path chapel-0001.path --step 0.25 --blended 8 --worst "
        "5");
}

namespace {

/// Throws Error(usage) if the measurements would overwrite anything but earlier ones.
void expect_smoothness_folder(const PackageReader& package, const SmoothnessOptions& o) {
    const Inputs inputs = inputs_of(package);
    expect_result_folder(o.folder, "steps.csv", Product::csv, {"summary.json"}, inputs, o.output.force);
    output_file(o.folder / "steps.svg", Product::plot, inputs, o.output.force);
    const auto is_step = [](const std::string& name) { return name.starts_with("step-"); };
    expect_result_pictures(o.folder, is_step, inputs, o.output.force);
}

}  // namespace

int smoothness_command(int argc, char** argv) {
    CLI::App app{
        "vantage-player smoothness flies along a path and measures how far the colors of surfaces jump from "
        "frame to frame."};
    SmoothnessOptions options;
    add_smoothness_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    if (!options.output.file.empty()) options.folder = options.output.file;
    const PackageReader package = opened_package(options.package.file, options.memory, options.output.quiet);
    expect_smoothness_folder(package, options);
    return run_smoothness(package, options);
}

}  // namespace vantage
