#pragma once
#include <cstdint>

#include "player/render/picture.h"

namespace vantage::bench {

/// The four channels of a pixel, as RGBA with straight alpha; (x, y) must lie in the picture.
const std::uint8_t* texel(const Picture& picture, int x, int y);

/// The `width` x `height` pixels that start at (x0, y0). Beyond the picture, its edge pixels are repeated.
Picture crop(const Picture& picture, int x0, int y0, int width, int height);

}  // namespace vantage::bench
