#include "player/options/shown/light_options.h"

#include "base/cli/command.h"
#include "base/text/error.h"

namespace vantage {

void add_light_options(const Command& c, LightOptions& o) {
    const std::string group = "Light";
    const Option light = c.choice("--light", o.shown.light,
                                  {{"photos", Light::photos},
                                   {"lamp", Light::lamp},
                                   {"raking", Light::raking},
                                   {"normals", Light::normals}},
                                  "photos (default: the light in the photos), or light on the bare geometry: "
                                  "lamp (at the viewer), raking (from a low angle), normals (surface normals "
                                  "as colors: right, up, toward the viewer)")
                             .group(group);
    c.pair("--lamp", o.lamp,
           "direction of the raking light, AZIMUTH,ELEVATION in degrees: azimuth 0 from the right of the "
           "picture, 90 from above; elevation above the picture's plane, 1 to 90 (default 135,15)")
        .group(group)
        .needs(light);
}

LightSettings light_settings(const LightOptions& o) {
    LightSettings out = o.shown;
    if (o.lamp.empty()) return out;
    if (out.light != Light::raking) throw Error(Exit::usage, "--lamp: expected --light raking with it");
    out.azimuth = o.lamp[0], out.elevation = o.lamp[1];
    if (!(out.elevation >= 1 && out.elevation <= 90))
        throw Error(Exit::usage, "--lamp: expected an azimuth, and an elevation from 1 to 90 degrees");
    return out;
}

}  // namespace vantage
