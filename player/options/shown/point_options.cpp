#include "player/options/shown/point_options.h"

#include <cstdlib>

#include "base/cli/command.h"
#include "base/text/error.h"

namespace vantage {

void add_point_options(const Command& c, PointOptions& o) {
    const std::string group = "Point cloud";
    c.choice("--points", o.show, {"on", "off", "alone"}, "on: with the model; off; alone: without the model")
        .group(group);
    c.choice("--point-color", o.color, {{"photos", PointColor::photos}, {"own", PointColor::own}},
             "photos: colors from the photos, where one of them shows the point (default without a mesh); "
             "own: the points' own colors (default with a mesh)")
        .group(group);
    c.text("--point-size", o.size,
           "diameter of points: as a factor of the gaps between points (2), in pixels (2px), or in input "
           "units (0.02u)")
        .type("SIZE")
        .group(group);
}

PointSettings point_settings(const PointOptions& o) {
    PointSettings out;
    out.show = o.show != "off";
    out.alone = o.show == "alone";
    out.color = o.color;
    char* unit = nullptr;
    out.size = std::strtod(o.size.c_str(), &unit);
    const std::string by = unit;
    if (by == "px") out.by = PointSize::pixels;
    if (by == "u") out.by = PointSize::world;
    if (!(out.size >= 1e-6 && out.size <= 1e6) || (!by.empty() && out.by == PointSize::gaps))
        throw Error(Exit::usage, "--point-size " + o.size +
                                     ": expected a factor such as 2, pixels such as 2px, or input units such "
                                     "as 0.02u, from 0.000001 to 1000000");
    return out;
}

}  // namespace vantage
