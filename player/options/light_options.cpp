#include "player/options/light_options.h"

#include <cmath>

#include "scene/error.h"

namespace vantage {

void add_light_options(CLI::App& app, LightOptions& o) {
    const std::string group = "Light";
    CLI::Option* light =
        app.add_option(
               "--light", o.shown.light,
               "photos (default: their own light), or light on the bare geometry: lamp (at the viewer), "
               "raking (from a "
               "low angle), normals (the surface's directions as colors: right, up, toward the viewer)")
            ->transform(CLI::CheckedTransformer(std::map<std::string, Light>{{"photos", Light::photos},
                                                                             {"lamp", Light::lamp},
                                                                             {"raking", Light::raking},
                                                                             {"normals", Light::normals}}))
            ->default_str("photos")
            ->group(group);
    app.add_option("--lamp", o.lamp,
                   "where the raking light comes from, AZIMUTH,ELEVATION in degrees: azimuth 0 from the "
                   "right of the picture, 90 "
                   "from above; elevation over the picture's plane, 1 to 90 (default 135,15)")
        ->delimiter(',')
        ->expected(2)
        ->group(group)
        ->needs(light);
    app.add_flag("--wireframe", o.shown.wireframe, "the borders of the mesh's triangles, over the picture")
        ->group(group);
    app.add_flag("--light-on-photos", o.shown.on_photos, "light times the photos, instead of on gray")
        ->group(group)
        ->needs(light);
}

LightSettings light_settings(const LightOptions& o) {
    LightSettings out = o.shown;
    if (o.lamp.empty()) return out;
    out.azimuth = o.lamp[0], out.elevation = o.lamp[1];
    if (!std::isfinite(out.azimuth) || !(out.elevation >= 1 && out.elevation <= 90))
        throw Error(Exit::usage, "--lamp: expected an azimuth, and an elevation from 1 to 90 degrees");
    return out;
}

}  // namespace vantage
