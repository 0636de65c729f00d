#pragma once
#include <cstddef>
#include <span>

#include "base/values/rgba_image.h"

namespace vantage {

/// Whether alpha is 255 everywhere.
bool is_opaque(std::span<const std::byte> rgba);
bool is_opaque(const RgbaImage& image);

/// The next coarser level, computed by a 2x2 box filter in linear light, weighted by alpha. If a side has an
/// odd number of texels, the last one is repeated, so that pixel coordinates are exactly halved.
RgbaImage halve(const RgbaImage& image);

}  // namespace vantage
