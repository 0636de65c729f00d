#pragma once
#include "base/values/rgba_image.h"
#include "base/values/tiling.h"

namespace vantage {

/// The image scaled down to `size`: by bilinear interpolation if `size` is above half of the image's size,
/// otherwise by area averaging (OpenCV).
RgbaImage reduced(const RgbaImage& image, const Level& size);

/// The photo's size scaled down to at most `longest` pixels on the long side, never larger than the photo.
Level thumbnail_size(int width, int height, int longest);

}  // namespace vantage
