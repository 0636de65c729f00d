#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vantage {

/// An RGBA8 image: sRGB, straight alpha, top row first.
struct RgbaImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    bool opaque = false;  ///< alpha is known to be 255 everywhere
};

/// An image of zeros, to be filled in.
inline RgbaImage blank_image(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4)};
}

}  // namespace vantage
