#include "player/measure/bench.h"

#include <map>
#include <string>

#include "cli/known_values.h"
#include "cli/real_range.h"
#include "output/output_file.h"
#include "output/package_inputs.h"
#include "player/commands/commands.h"
#include "player/commands/parse.h"
#include "player/options/opened_package.h"

namespace vantage {

void add_bench_options(CLI::App& app, BenchOptions& o, UnusedOptions& unused) {
    add_package_options(app, o.package);
    add_object_options(app, o.objects);
    add_output_options(app, o.output);
    add_memory_options(app, o.memory);
    add_blending_options(app, o.blending);
    add_second_band_options(app, o.blending.bands);
    add_point_options(app, o.points);
    add_unused_options(app, unused);
    hide(app, {"--quiet"});
    const std::string group = "Bench";
    for (const char* used : {"--fps", "--stereo", "--eye-distance"})  // not unused here
        app.get_option(used)->group(group);
    app.add_option("--paths", o.paths, "paths to fly: these, or files of views")
        ->type_name("FILE")
        ->check(known_values({"still", "orbit", "approach", "jump", "flight"}))
        ->delimiter(',')
        ->capture_default_str()
        ->group(group);
    app.add_option(
           "--modes", o.modes,
           "stream: within the upload budget of each frame; resident: everything loaded beforehand; whole: "
           "each photo uploaded whole when it is chosen; adaptive: as stream, in motion as in a window "
           "(--fps)")
        ->delimiter(',')
        ->check(CLI::IsMember({"stream", "resident", "whole", "adaptive"}))
        ->capture_default_str()
        ->group(group);
    app.add_option("--path-frames", o.frames, "frames per path")
        ->check(CLI::Range(2, 1 << 20))
        ->capture_default_str()
        ->group(group);
    app.add_option("--minutes", o.minutes, "fly each path for this long instead")
        ->check(real_range(0, 1e4))
        ->group(group);
    app.add_flag("--until-exact", o.until_exact,
                 "end the paths still and jump as soon as the picture is exact (one object)")
        ->group(group);
    app.add_option("--repeats", o.repeats, "flights of each path and mode")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str()
        ->group(group);
    app.add_option("--sweep", o.sweep,
                   "instead of paths, a still view with 1, 2, 4, ... photos per pass (passes) or photos "
                   "blended (photos)")
        ->check(CLI::IsMember({"passes", "photos"}))
        ->group(group);
    app.add_option("--pictures", o.pictures, "frames of each path to save as PNG, evenly spread")
        ->check(CLI::Range(0, 1 << 20))
        ->group(group);
    app.add_option("--point-culling", o.points.culling)  // to measure what culling is worth
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, PointCulling>{{"hierarchical", PointCulling::hierarchical},
                                                {"leaves", PointCulling::leaves},
                                                {"none", PointCulling::none}}))
        ->group("");
    app.add_flag("!--by-model", o.blending.render.by_triangle,
                 "blend photos on the model drawn again for each pass, not once per pixel (to compare)")
        ->group(group);
    app.add_flag("--warm", o.warm, "keep the package in the page cache")->group(group);
    app.footer(
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
}

namespace {

/// Throws Error(usage) if the measurements would overwrite anything but earlier ones.
void expect_bench_folder(const PackageReader& package, const BenchOptions& o) {
    const Inputs inputs = inputs_of(package);
    if (!o.sweep.empty()) {
        output_file(o.folder / ("sweep-" + o.sweep + ".svg"), Product::plot, inputs, o.output.force);
        return;
    }
    expect_result_folder(o.folder, "frames.csv", Product::csv, {"summary.json"}, inputs, o.output.force);
    for (const std::string& path : o.paths)
        output_file(o.folder / (std::filesystem::path(path).stem().string() + ".svg"), Product::plot, inputs,
                    o.output.force);
}

}  // namespace

int bench_command(int argc, char** argv) {
    CLI::App app{"vantage-player bench flies scripted paths and measures every frame."};
    BenchOptions options;
    UnusedOptions unused;
    add_bench_options(app, options, unused);
    if (const auto code = parse(app, argc, argv)) return *code;
    if (unused.pictures.offscreen) options.purpose = Purpose::pictures;
    options.fps = unused.window.fps;
    options.stereo = unused.stereo;
    if (!options.output.file.empty()) options.folder = options.output.file;
    options.scene = named_objects(options.package, options.objects);
    const PackageReader package =
        opened_package(options.scene.front().package, options.memory, options.output.quiet);
    expect_bench_folder(package, options);
    return run_bench(package, options);
}

}  // namespace vantage
