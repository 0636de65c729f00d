#include "scene/agreement/transient_weights.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

/// The bilinearly interpolated weight, 0 to 255, at a position in texels of the map.
double weight_at(const TransientMap& map, double x, double y) {
    const auto texel = [&](int i, int j) {
        return double(map.weight[std::size_t(std::clamp(j, 0, map.height - 1)) * std::size_t(map.width) +
                                 std::size_t(std::clamp(i, 0, map.width - 1))]);
    };
    const int i = int(std::floor(x - 0.5)), j = int(std::floor(y - 0.5));
    const double u = x - 0.5 - i, v = y - 0.5 - j;
    return (1 - v) * ((1 - u) * texel(i, j) + u * texel(i + 1, j)) +
           v * ((1 - u) * texel(i, j + 1) + u * texel(i + 1, j + 1));
}

}  // namespace

void set_weights(const TransientMap* map, const Level& level, Grid<std::byte> texels, int left, int top) {
    const double across = map ? double(map->width) / level.width : 0,
                 down = map ? double(map->height) / level.height : 0;
    for (int j = 0; j < texels.height; ++j)
        for (int i = 0; i < texels.width / 4; ++i) {
            std::byte& weight = texels(4 * i + 3, j);
            if (weight == std::byte(0)) continue;
            const int x = std::clamp(left + i, 0, level.width - 1),
                      y = std::clamp(top + j, 0, level.height - 1);
            const double w = map ? weight_at(*map, (x + 0.5) * across, (y + 0.5) * down) : 255;
            weight = std::byte(std::clamp(std::lround(w), 1l, 255l));
        }
}

void set_tile_weights(const TransientMap* map, const Level& level, std::size_t tile,
                      std::span<std::byte> texels) {
    const int row = int(tile) / level.columns(), column = int(tile) % level.columns();
    set_weights(map, level, {texels.data(), 4 * tile_size, tile_size}, column * tile_content - tile_border,
                row * tile_content - tile_border);
}

}  // namespace vantage
