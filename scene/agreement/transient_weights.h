#pragma once
#include <cstddef>
#include <span>

#include "base/values/tiling.h"
#include "scene/agreement/transient_map.h"

namespace vantage {

/// Sets the fourth channel of texels of weight maps to the map's weights, bilinear: 255 without a map (null),
/// at least 1 where the photo sees the model, unchanged 0 elsewhere. `level`: the size of the whole level;
/// `texels`: 4 bytes each, the first at column `left`, row `top` of the level, positions beyond it are those
/// of its edge.
void set_weights(const TransientMap* map, const Level& level, Grid<std::byte> texels, int left, int top);

/// The same for a stored tile of the level.
void set_tile_weights(const TransientMap* map, const Level& level, std::size_t tile,
                      std::span<std::byte> texels);

}  // namespace vantage
