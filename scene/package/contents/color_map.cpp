#include "scene/package/contents/color_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace vantage {
namespace {

/// Seventeen equidistant colors, as 0xRRGGBB, between which sRGB values are interpolated.
using Stops = std::array<std::uint32_t, 17>;

constexpr Stops viridis{0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d,
                        0x2c728e, 0x26828e, 0x21908c, 0x1f9f88, 0x27ad81, 0x3ebc74,
                        0x5cc863, 0x82d34d, 0xaadc32, 0xd5e21a, 0xfde725};
constexpr Stops magma{0x000004, 0x0a0822, 0x1d1147, 0x36106b, 0x50127c, 0x691c81,
                      0x822681, 0x9c2e7f, 0xb6367a, 0xcf4070, 0xe65164, 0xf46a5c,
                      0xfb8861, 0xfea571, 0xfec287, 0xfde0a1, 0xfcfdbf};
constexpr Stops cividis{0x00224e, 0x002e6a, 0x1a386f, 0x32436d, 0x434e6c, 0x535a6d,
                        0x61656f, 0x6f7073, 0x7c7c78, 0x8b8778, 0x9a9376, 0xaaa073,
                        0xbbad6d, 0xccba64, 0xddc858, 0xefd748, 0xfee838};
constexpr Stops coolwarm{0x3b4cc0, 0x4e68d7, 0x6282ea, 0x779af7, 0x8db0fe, 0xa3c2ff,
                         0xb8d0f9, 0xccd9ee, 0xdddddd, 0xecd3c6, 0xf5c4ad, 0xf7b194,
                         0xf49a7b, 0xec7f63, 0xde614c, 0xcb3e38, 0xb40426};

const Stops& stops_of(ColorMap map) {
    switch (map) {
        case ColorMap::magma:
            return magma;
        case ColorMap::cividis:
            return cividis;
        case ColorMap::coolwarm:
            return coolwarm;
        default:
            return viridis;
    }
}

}  // namespace

ColorTable color_table(ColorMap map, double center) {
    const Stops& stops = stops_of(map);
    const bool diverges = map == ColorMap::coolwarm;
    ColorTable out{};
    for (std::size_t i = 0; i < out.size(); ++i) {
        double place = double(i) / double(out.size() - 1);
        if (diverges) place = 0.5 + (place - center) / (2 * std::max(center, 1 - center));
        const double at = std::clamp(place, 0.0, 1.0) * double(stops.size() - 1);
        const std::size_t first = std::min(std::size_t(at), stops.size() - 2);
        const double share = at - double(first);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto code = [&](std::uint32_t stop) { return double(stop >> (16 - 8 * c) & 255); };
            out[i][c] =
                std::uint8_t(std::lround((1 - share) * code(stops[first]) + share * code(stops[first + 1])));
        }
        out[i][3] = 255;
    }
    return out;
}

const char* name_of(ColorMap map) {
    constexpr const char* names[] = {"auto", "viridis", "magma", "cividis", "coolwarm"};
    static_assert(std::size(names) == std::size_t(ColorMap::count));
    return names[std::size_t(map)];
}

ColorMap chosen_map(ColorMap map, double low, double high) {
    if (map != ColorMap::automatic) return map;
    return low < 0 && high > 0 ? ColorMap::coolwarm : ColorMap::viridis;
}

}  // namespace vantage
