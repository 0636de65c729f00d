#include "player/options/shown/layer_options.h"

#include "base/cli/command.h"
#include "base/text/error.h"
#include "scene/package/contents/photo_layers.h"

namespace vantage {

void add_layer_options(const Command& c, LayerOptions& o) {
    const std::string group = "Scalar layers";
    const Option name =
        c.text("--layer", o.name,
               "show this layer of values instead of the photos: one of the package ('vantage info' lists "
               "them under scalar-layers), photo-count (how many photos see the surface) or photo-density "
               "(pixels per input unit of the finest of them)")
            .group(group);
    c.pair("--layer-range", o.range,
           "values at the ends of the color map, LOW,HIGH; beyond, the end's color (default: lowest and "
           "highest value)")
        .group(group)
        .needs(name);
    c.integer("--isolines", o.shown.isolines, 0, 100, "lines that divide the color map into this many parts")
        .group(group)
        .needs(name);
}

LayerSettings layer_settings(const PackageReader& package, const LayerOptions& o) {
    LayerSettings out = o.shown;
    if (o.name.empty()) return out;
    const std::vector<ValueLayer> layers = all_layers(package);
    out.layer = layer_named(layers, o.name);
    if (o.range.empty()) return out;
    const double low = o.range[0], high = o.range[1];
    if (!(low < high)) throw Error(Exit::usage, "--layer-range: expected two numbers, the lower one first");
    out.range = ValueRange{low, high};
    return out;
}

}  // namespace vantage
