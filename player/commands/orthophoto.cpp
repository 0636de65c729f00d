#include "player/orthophoto/orthophoto.h"

#include "cli/real_range.h"
#include "player/commands/commands.h"
#include "player/commands/parse.h"
#include "player/options/opened_package.h"

namespace vantage {

void add_orthophoto_options(CLI::App& app, OrthophotoOptions& o) {
    add_package_options(app, o.package);
    add_output_options(app, o.output);
    add_memory_options(app, o.memory);
    add_blending_options(app, o.blending);
    add_light_options(app, o.light);
    hide(app, {"--size", "--photo", "--upload", "--blended", "--surroundings"});
    const std::string group = "Orthophoto";
    app.add_option(
           "--plane", o.plane,
           "top, bottom, front, back, left or right; or a point, the normal toward the viewer and the "
           "picture's up direction: PX,PY,PZ,NX,NY,NZ[,UX,UY,UZ]")
        ->capture_default_str()
        ->group(group);
    app.add_option("--resolution", o.resolution, "units of the model per pixel")
        ->check(real_range(1e-12, 1e12))
        ->required()
        ->group(group);
    app.add_option("--extent", o.extent,
                   "LEFT,BOTTOM,RIGHT,TOP in coordinates of the plane (default: the whole model)")
        ->group(group);
    app.add_option("--samples", o.samples, "samples per side of a pixel")
        ->check(CLI::Range(1, 8))
        ->capture_default_str()
        ->group(group);
    app.footer(
        "Writes a picture, transparent where nothing is: a GeoTIFF (.tif), or a PNG and beside it a world "
        "file\n"
        "(.pgw). Both tell its place on the plane.\n"
        "With z up, top has the model's x to the right and y upwards, and front is seen along y. The plane's "
        "coordinates\n"
        "begin at the model's origin, or at the point that is given.\n"
        "Examples:\n"
        "  vantage-player orthophoto chapel.vantage --resolution 0.005 -o plan.tif\n"
        "  vantage-player orthophoto chapel.vantage --plane front --resolution 0.002 --extent -3,0,3,5 -o "
        "door.png\n"
        "  vantage-player orthophoto chapel.vantage --plane 0,0,0,1,-1,0 --resolution 0.01 --light raking -o "
        "relief.png");
}

int orthophoto_command(int argc, char** argv) {
    CLI::App app{
        "vantage-player orthophoto projects the model on a plane, at right angles, and writes a picture true "
        "to "
        "scale."};
    OrthophotoOptions options;
    add_orthophoto_options(app, options);
    if (const auto code = parse(app, argc, argv)) return *code;
    const PackageReader package = opened_package(options.package.file, options.memory, options.output.quiet);
    return run_orthophoto(package, options);
}

}  // namespace vantage
