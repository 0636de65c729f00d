#pragma once
#include <cstddef>
#include <span>

#include "base/values/rgba_image.h"

namespace vantage {

/// Whether alpha is 255 everywhere.
bool is_opaque(std::span<const std::byte> rgba);
bool is_opaque(const RgbaImage& image);

/// The next coarser level: 2x2 box filter in linear light, weighted by alpha. Odd edges repeat their last
/// texel, so that pixel coordinates are exactly halved.
RgbaImage halve(const RgbaImage& image);

}  // namespace vantage
