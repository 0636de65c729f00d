#pragma once
#include <cstddef>
#include <span>

#include "base/values/tiling.h"
#include "scene/agreement/transient_map.h"

namespace vantage {

/// Sets the fourth channel of weight-map texels to the map's weights, interpolated bilinearly. Without a map
/// (null), the weight is 255. The weight is at least 1 where the photo sees the model, and remains 0
/// elsewhere. `level`: the size of the whole level; `texels`: 4 bytes each, starting at column `left` and row
/// `top` of the level. Positions beyond the level are clamped to its edge.
void set_weights(const TransientMap* map, const Level& level, Grid<std::byte> texels, int left, int top);

/// Sets the weights of a stored tile of a level in the same way.
void set_tile_weights(const TransientMap* map, const Level& level, std::size_t tile,
                      std::span<std::byte> texels);

}  // namespace vantage
