#include "player/options/layer_options.h"

#include <cmath>

#include "cli/real_range.h"
#include "layers/photo_layers.h"
#include "scene/error.h"

namespace vantage {

void add_layer_options(CLI::App& app, LayerOptions& o) {
    const std::string group = "Scalar layers";
    CLI::Option* name =
        app.add_option("--layer", o.name,
                       "show this layer of values instead of the photos: one of the package "
                       "('vantage info' lists them under scalar-layers), photo-count (how many "
                       "photos see the surface) or photo-density (pixels per input unit of the "
                       "finest of them)")
            ->group(group);
    const auto add = [&](CLI::Option* option) { return option->group(group)->needs(name); };
    add(app.add_option("--color-map", o.shown.map,
                       "colors from the lowest to the highest value: viridis, magma, cividis (also for the "
                       "color-blind), coolwarm (about 0), or auto: coolwarm for values of both signs, else "
                       "viridis")
            ->transform(
                CLI::CheckedTransformer(std::map<std::string, ColorMap>{{"auto", ColorMap::automatic},
                                                                        {"viridis", ColorMap::viridis},
                                                                        {"magma", ColorMap::magma},
                                                                        {"cividis", ColorMap::cividis},
                                                                        {"coolwarm", ColorMap::coolwarm}}))
            ->default_str("auto"));
    add(app.add_option("--layer-range", o.range,
                       "values at the ends of the color map, LOW,HIGH; beyond, the end's color (default: "
                       "lowest and highest value)")
            ->delimiter(',')
            ->expected(2));
    add(app.add_flag("--layer-log", o.shown.logarithmic,
                     "logarithmic; what is not positive counts as without value"));
    add(app.add_option("--isolines", o.shown.isolines, "lines that divide the color map into this many parts")
            ->check(CLI::Range(0, 100))
            ->capture_default_str());
    add(app.add_option("--layer-share", o.shown.share, "share of the layer beside the photos, 0 to 1")
            ->check(real_range(0.0, 1.0))
            ->capture_default_str());
}

LayerSettings layer_settings(const PackageReader& package, const LayerOptions& o) {
    LayerSettings out = o.shown;
    if (o.name.empty()) return out;
    const std::vector<ValueLayer> layers = all_layers(package);
    out.layer = layer_named(layers, o.name);
    if (o.range.empty()) return out;
    const double low = o.range[0], high = o.range[1];
    if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
        throw Error(Exit::usage, "--layer-range: expected two numbers, the lower one first");
    if (out.logarithmic && !(low > 0))
        throw Error(Exit::usage, "--layer-range: expected numbers above 0 with --layer-log");
    out.range = ValueRange{low, high};
    return out;
}

}  // namespace vantage
