#include "player/options/point_options.h"

#include <map>
#include <string>

#include "cli/real_range.h"

namespace vantage {

void add_point_options(CLI::App& app, PointSettings& o) {
    const std::string group = "Point cloud";
    app.add_option_function<std::string>(
           "--points",
           [&o](const std::string& text) {
               o.show = text != "off";
               o.alone = text == "alone";
           },
           "on: with the model (default); off; alone: without the model")
        ->check(CLI::IsMember({"on", "off", "alone"}))
        ->group(group);
    app.add_option(
           "--point-color", o.color,
           "photos: those of the photos, where one shows the point (default without a mesh); own: their "
           "own (default with a mesh)")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, PointColor>{{"photos", PointColor::photos}, {"own", PointColor::own}}))
        ->group(group);
    app.add_option("--point-size-by", o.by,
                   "gaps: points are as large as they are apart; pixels; world: input units")
        ->transform(CLI::CheckedTransformer(std::map<std::string, PointSize>{
            {"gaps", PointSize::gaps}, {"pixels", PointSize::pixels}, {"world", PointSize::world}}))
        ->default_str("gaps")
        ->group(group);
    app.add_option("--point-size", o.size, "diameter: pixels, input units, or a factor for gaps")
        ->check(real_range(1e-6, 1e6))
        ->capture_default_str()
        ->group(group);
    app.add_option("--point-budget", o.budget,
                   "points per frame, at most (but the coarsest level is always drawn): the nearest and "
                   "coarsest first")
        ->check(CLI::Range(std::uint64_t(1), std::uint64_t(20'000'000)))
        ->capture_default_str()
        ->group(group);
    app.add_option("--eye-dome", o.eye_dome, "strength of the shading of points by depth, 0 for none")
        ->check(real_range(0.0, 10.0))
        ->capture_default_str()
        ->group(group);
}

}  // namespace vantage
