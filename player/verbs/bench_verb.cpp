#include "player/measure/bench/bench.h"
#include "player/options/frame_goal.h"
#include "player/options/shown/opened_package.h"
#include "player/verbs/verbs.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

/// Throws Error(usage) if the measurements would overwrite anything but earlier measurements.
void expect_bench_folder(const PackageReader& package, const BenchOptions& o) {
    const Inputs inputs = inputs_of(package);
    expect_result_folder(o.folder, "frames.csv", Product::csv, {"summary.json"}, inputs, o.output.force);
    for (const std::string& path : o.paths)
        output_file(o.folder / (std::filesystem::path(path).stem().string() + ".svg"), Product::plot, inputs,
                    o.output.force);
}

int bench(BenchOptions o) {
    if (!o.output.file.empty()) o.folder = o.output.file;
    o.scene = named_objects(o.package, o.objects);
    const PackageReader package = opened_package(o.scene.front().package, o.memory);
    expect_bench_folder(package, o);
    return run_bench(package, o);
}

void add_flights(const Command& c, BenchOptions& o) {
    const std::string group = "Bench";
    c.list("--paths", o.paths, "paths to fly: any of these names, or files of views")
        .type("FILE")
        .suggests({"still", "orbit", "approach", "jump", "flight"})
        .commas()
        .group(group);
    c.choices("--modes", o.modes, {"stream", "resident", "whole", "adaptive"},
              "stream: tiles are uploaded within each frame's budget; resident: everything is loaded in "
              "advance; whole: photos are uploaded completely when they are selected; adaptive: like stream, "
              "at the pace of a window (--fps)")
        .commas()
        .group(group);
    c.integer("--path-frames", o.frames, 2, 1 << 20, "frames per path").group(group);
    c.real("--minutes", o.minutes, 0.001, 1e4, "fly each path for this time instead of a number of frames")
        .group(group);
    add_fps_option(c, o.fps, group);
    c.flag("--until-exact", o.until_exact,
           "end the paths still and jump as soon as the picture is exact (only for one object)")
        .group(group);
    c.integer("--repeats", o.repeats, 1, 1000, "number of flights for each path and mode").group(group);
    c.flag("--warm", o.warm, "keep the package in the page cache").group(group);
}

}  // namespace

void add_bench(const Command& program) {
    const auto o = std::make_shared<BenchOptions>();
    const Command c = program.verb("bench", "Fly scripted paths and measure every frame");
    add_package_argument(c, o->package).required();
    add_exclude_option(c, o->package);
    add_photo_option(c, o->package, "photo whose camera is the start of flights");
    add_object_options(c, o->objects);
    add_size_option(c, o->output);
    add_output_options(c, o->output);
    add_memory_options(c, o->memory);
    add_upload_option(c, o->memory);
    add_blending_options(c, o->blending);
    add_second_image_set_options(c, o->blending.image_sets);
    add_blended_option(c, o->blending);
    add_background_option(c, o->blending);
    add_transparency_option(c, o->blending);
    add_point_options(c, o->points);
    add_stereo_options(c, o->stereo);
    add_flights(c, *o);
    c.notes(
        "Writes frames.csv, summary.json and a plot per path into the folder given by -o (default bench).\n"
        "Examples:\n"
        "  vantage-player bench chapel.vantage\n"
        "  vantage-player bench chapel.vantage --paths orbit --modes stream,resident --repeats 5 -o orbit\n"
        "  vantage-player bench church.toml --paths orbit\n"
        "  vantage-player bench chapel.vantage --paths orbit --modes stream,adaptive --fps 15\n"
        "  vantage-player bench chapel.vantage --paths orbit --stereo side-by-side --size 960x1080\n"
        "  vantage-player bench https://museum.org/chapel.vantage --paths still --modes stream "
        "--until-exact\n"
        "  vantage-player bench chapel.vantage --paths flight --modes stream --minutes 10 --graphics-memory "
        "256");
    c.action([o] { return bench(*o); });
}

}  // namespace vantage
