#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/pixels/rgba_image.h"
#include "scene/tiling.h"

namespace vantage {

/// Alpha is 255 everywhere.
bool is_opaque(const RgbaImage& image);

/// The next coarser level: 2x2 box in linear light, weighted by alpha; odd edges repeat their last texel, so
/// a pixel coordinate halves exactly.
RgbaImage halve(const RgbaImage& image);

/// Cuts one stored tile (row by row from the upper left) with its border out of a level of 4-byte texels;
/// edges of the level repeat their last texel. `texels` has level.width * level.height * 4 bytes, `tile`
/// tile_bytes.
void cut_tile(std::span<const std::byte> texels, const Level& level, std::size_t number,
              std::span<std::byte> tile);

/// To a size that is no larger: area average, above half the size linear between texels.
RgbaImage reduced(const RgbaImage& image, const Level& size);
/// At most `longest` pixels on the long side, never larger than the photo.
Level thumbnail_size(int width, int height, int longest);

}  // namespace vantage
