#include "player/options/shown/opened_package.h"
#include "player/pictures/orthophoto.h"
#include "player/verbs/verbs.h"

namespace vantage {

void add_orthophoto(const Command& program) {
    const auto o = std::make_shared<OrthophotoOptions>();
    const Command c = program.verb("orthophoto", "Write an orthographic picture, true to scale");
    add_package_argument(c, o->package).required();
    add_exclude_option(c, o->package);
    add_output_options(c, o->output);
    add_memory_options(c, o->memory);
    add_blending_options(c, o->blending);
    add_holes_option(c, o->blending);
    add_transparency_option(c, o->blending);
    add_light_options(c, o->light);
    const std::string group = "Orthophoto";
    c.text("--plane", o->plane,
           "top, bottom, front, back, left or right; or a point, the normal toward the viewer and the "
           "picture's up direction: PX,PY,PZ,NX,NY,NZ[,UX,UY,UZ]")
        .group(group);
    c.real("--resolution", o->resolution, 1e-12, 1e12, "units of the model per pixel")
        .required()
        .group(group);
    c.text("--extent", o->extent,
           "LEFT,BOTTOM,RIGHT,TOP in coordinates of the plane (default: the whole model)")
        .group(group);
    c.list("--cut", o->cuts,
           "cut the model with a plane (at most 6): a point on it and the normal toward the removed part, "
           "PX,PY,PZ,NX,NY,NZ")
        .one_word()
        .group(group);
    c.integer("--samples", o->samples, 1, 8, "samples per side of a pixel").group(group);
    c.notes(
        "Writes a picture, transparent outside the model: a GeoTIFF (.tif), or a PNG with a world file\n"
        "(.pgw). Both formats store the picture's position on the plane.\n"
        "With z up, top shows the model's x to the right and y upward, and front looks along y. The plane's "
        "coordinates\n"
        "start at the model's origin, or at the given point.\n"
        "Examples:\n"
        "  vantage-player orthophoto chapel.vantage --resolution 0.005 -o plan.tif\n"
        "  vantage-player orthophoto chapel.vantage --plane front --resolution 0.002 --extent -3,0,3,5 -o "
        "door.png\n"
        "  vantage-player orthophoto chapel.vantage --plane 0,0,0,1,-1,0 --resolution 0.01 --light raking -o "
        "relief.png");
    c.action([o] { return run_orthophoto(opened_package(o->package.file, o->memory), *o); });
}

}  // namespace vantage
