#include "pipeline/reports/page/weight_picture.h"

#include <algorithm>
#include <cmath>

#include "scene/agreement/read_level.h"

namespace vantage {

// From Okabe and Ito's palette, which color-blind readers can tell apart.
const std::array<WeightColor, 6> weight_colors{{
    {"full weight",
     "the surface is seen from the front, at the finest resolution of all photos, away from edges",
     {255, 255, 255}},
    {"at a slant", "the surface is turned away from the camera", {0, 114, 178}},
    {"from afar",
     "other photos show finer detail, because they are nearer or have a longer lens",
     {0, 158, 115}},
    {"near an edge",
     "the surface is close to the edge of the photo, or to an outline behind which it is hidden",
     {230, 159, 0}},
    {"contradicted", "other photos agree on a different color there, and are shown instead", {194, 24, 91}},
    {"nothing seen", "the photo shows no surface of the model", {200, 200, 200}},
}};

namespace {

using package::PhotoRecord;
using package::Type;

enum Color : std::size_t { full, slant, far, edge, contradicted, nothing };

double focal(const PhotoRecord& p) { return std::sqrt(p.fx * p.fy); }

std::array<std::uint8_t, 3> mixed(Color color, double share) {
    std::array<std::uint8_t, 3> out = weight_colors[full].color;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = std::uint8_t(std::lround(out[c] + share * (weight_colors[color].color[c] - out[c])));
    return out;
}

/// `fullest`: the depth code of the finest density in the scene.
std::array<std::uint8_t, 3> shown(const std::uint8_t* weight_maps, double fullest) {
    if (weight_maps[0] == 0 && weight_maps[1] == 0 && weight_maps[2] == 0 && weight_maps[3] == 0)
        return weight_colors[nothing].color;
    const double density = std::exp2((weight_maps[1] - fullest) / 12);
    const std::array<std::pair<double, Color>, 4> factors{{{weight_maps[0] / 255.0, slant},
                                                           {std::min(1.0, density), far},
                                                           {weight_maps[2] / 255.0, edge},
                                                           {weight_maps[3] / 255.0, contradicted}}};
    const auto [least, color] = *std::ranges::min_element(factors, {}, &std::pair<double, Color>::first);
    return mixed(color, 1 - least);
}

}  // namespace

double best_density(std::span<const PhotoRecord> photos) {
    double finest = 0;
    for (const PhotoRecord& p : photos)
        if (p.seen_distance > 0) finest = std::max(finest, focal(p) / p.seen_distance);
    return finest;
}

RgbaImage weight_picture(const PackageReader& package, std::uint32_t photo, double finest, int longest) {
    const PhotoRecord& p = package.photos()[photo];
    int level = weight_map_level;
    while (level + 1 < weight_map_levels_end(int(p.levels)) &&
           int(std::max(p.width, p.height)) >> level > longest)
        ++level;
    RgbaImage out{1, 1, {200, 200, 200, 255}, true};
    if (!package.find(Type::weight_maps, photo, std::uint32_t(level))) return out;
    const double reference = package.scene().reference_density;
    const double fullest = finest > 0 && reference > 0 ? 255 + 12 * std::log2(finest / reference) : 255;
    out = read_level_image(package, p, photo, Type::weight_maps, level);
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) {
        const auto color = shown(&out.rgba[i], fullest);
        std::ranges::copy(color, out.rgba.begin() + std::ptrdiff_t(i));
        out.rgba[i + 3] = 255;
    }
    return out;
}

}  // namespace vantage
