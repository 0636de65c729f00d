#include "player/measure/bench/smoothness.h"
#include "player/options/shown/opened_package.h"
#include "player/verbs/verbs.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

/// Throws Error(usage) if the measurements would overwrite anything but earlier measurements.
void expect_smoothness_folder(const PackageReader& package, const SmoothnessOptions& o) {
    const Inputs inputs = inputs_of(package);
    expect_result_folder(o.folder, "steps.csv", Product::csv, {"summary.json"}, inputs, o.output.force);
    output_file(o.folder / "steps.svg", Product::plot, inputs, o.output.force);
    const auto is_step = [](const std::string& name) { return name.starts_with("step-"); };
    expect_result_pictures(o.folder, is_step, inputs, o.output.force);
}

int measure_smoothness(SmoothnessOptions o) {
    if (!o.output.file.empty()) o.folder = o.output.file;
    const PackageReader package = opened_package(o.package.file, o.memory);
    expect_smoothness_folder(package, o);
    return run_smoothness(package, o);
}

}  // namespace

void add_smoothness(const Command& program) {
    const auto o = std::make_shared<SmoothnessOptions>();
    const Command c = program.verb("smoothness", "Measure color jumps between the frames of a flight");
    add_package_argument(c, o->package).required();
    add_exclude_option(c, o->package);
    add_photo_option(c, o->package, "photos to fly along, or 'all'");
    add_size_option(c, o->output);
    add_output_options(c, o->output);
    add_memory_options(c, o->memory);
    add_blending_options(c, o->blending);
    add_blended_option(c, o->blending);
    add_background_option(c, o->blending);
    const std::string group = "Smoothness";
    c.file("--path", o->path,
           "file of views to fly along (default: the cameras of all photos or of those of --photo, from each "
           "camera to the nearest remaining one)")
        .group(group);
    c.real("--step", o->step, 0.01, 90,
           "rotation of the camera or movement around its target, in degrees per frame")
        .group(group);
    c.integer("--worst", o->worst, 0, 1000, "number of steps to save as PNG files, the largest first")
        .group(group);
    c.notes(
        "Each frame is drawn as in the window (640x360 by default, 30 per second, 4 photos), with all tiles "
        "loaded, and\nagain with the photos and weights of the next frame: the difference is the color jump "
        "of surfaces without\nmovement. It is averaged in cells whose side is 1/40 of the picture's width. "
        "Prints the mean over a picture's\ncells and their 99th percentile, per frame and per degree of "
        "movement.\n"
        "Writes steps.csv, summary.json, steps.svg and the largest steps as step-FRAME.png into the folder "
        "given by -o\n(default smoothness). These pictures show the frame, the frame with the weights of the "
        "next one, and eight times\nthe difference.\n"
        "Examples:\n"
        "  vantage-player smoothness chapel.vantage\n"
        "  vantage-player smoothness chapel.vantage --original-colors -o as-taken\n"
        "  vantage-player smoothness chapel.vantage --path chapel-0001.path --step 0.25 --max-photos 8 "
        "--worst "
        "5");
    c.action([o] { return measure_smoothness(*o); });
}

}  // namespace vantage
