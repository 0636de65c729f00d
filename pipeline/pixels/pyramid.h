#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/tiling.h"
#include "values/rgba_image.h"

namespace vantage {

/// Cuts one stored tile with its border out of a level of 4-byte texels. Tiles are numbered row by row from
/// the upper left; beyond the level's edges its last texel is repeated. `texels` holds level.width *
/// level.height * 4 bytes, `tile` holds tile_bytes.
void cut_tile(std::span<const std::byte> texels, const Level& level, std::size_t number,
              std::span<std::byte> tile);

/// Scaled down to `size`: bilinear above half of the image's size, else the area average (OpenCV).
RgbaImage reduced(const RgbaImage& image, const Level& size);

/// The photo's size scaled down to at most `longest` pixels on the long side, never larger than the photo.
Level thumbnail_size(int width, int height, int longest);

}  // namespace vantage
