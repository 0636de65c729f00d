#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// One value per pixel, row by row from the top.
struct Plane {
    int width = 0, height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h), 0.0f) {}
    float* row(int y) { return values.data() + std::size_t(y) * std::size_t(width); }
    const float* row(int y) const { return values.data() + std::size_t(y) * std::size_t(width); }
    double at(int x, int y) const { return double(row(y)[x]); }
};

/// BT.601 luminance after gains, in gray levels, rounded as in 8-bit pictures.
Plane luminance(const Picture& picture, const std::array<double, 3>& gain = {1, 1, 1});

/// Gaussian-weighted sums around every pixel: sigma 1.5 px, 11x11; values outside the frame count as 0.
Plane blurred(const Plane& plane);

}  // namespace vantage
