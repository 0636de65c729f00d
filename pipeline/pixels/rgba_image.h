#pragma once
#include <cstdint>
#include <vector>

namespace vantage {

/// RGBA8, sRGB, straight alpha; row 0 on top.
struct RgbaImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    bool opaque = false;  ///< known to have alpha 255 everywhere
};

}  // namespace vantage
