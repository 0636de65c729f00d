#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace vantage {

/// Converts an sRGB value to linear light, both in [0, 1] (IEC 61966-2-1).
inline double linear_from_srgb(double s) {
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// Converts linear light to an sRGB value, both in [0, 1].
inline double srgb_from_linear(double l) {
    return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

/// The linear light, in [0, 1], of each sRGB byte.
inline const std::array<double, 256>& linear_of_srgb_byte() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> t;
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = linear_from_srgb(double(i) / 255);
        return t;
    }();
    return table;
}

}  // namespace vantage
