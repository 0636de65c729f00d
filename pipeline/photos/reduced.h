#pragma once
#include "base/values/rgba_image.h"
#include "base/values/tiling.h"

namespace vantage {

/// The image scaled down to `size`: with bilinear interpolation above half of the image's size, otherwise
/// with the area average (OpenCV).
RgbaImage reduced(const RgbaImage& image, const Level& size);

/// The photo's size scaled down to at most `longest` pixels on the long side, never larger than the photo.
Level thumbnail_size(int width, int height, int longest);

}  // namespace vantage
