#pragma once
#include <cstddef>
#include <span>

#include "base/values/tiling.h"

namespace vantage {

/// Cuts one stored tile, including its border, out of a level of 4-byte texels. Tiles are numbered row by row
/// from the upper left; beyond the level's edges, the last texel is repeated. `texels` holds level.width *
/// level.height * 4 bytes, and `tile` holds tile_bytes.
void cut_tile(std::span<const std::byte> texels, const Level& level, std::size_t number,
              std::span<std::byte> tile);

}  // namespace vantage
