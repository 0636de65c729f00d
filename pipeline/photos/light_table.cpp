#include "pipeline/photos/light_table.h"

#include <algorithm>
#include <cmath>

#include "base/values/srgb.h"

namespace vantage {
namespace {

constexpr float top = float(channel_values - 1);

/// A table of sRGB bytes for linear light in steps of 1 / top.
const std::vector<std::uint8_t>& srgb_codes() {
    static const std::vector<std::uint8_t> codes = [] {
        std::vector<std::uint8_t> table(channel_values);
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = std::uint8_t(std::lround(255 * srgb_from_linear(double(i) / double(top))));
        return table;
    }();
    return codes;
}

/// Writes the sum r + g + b as three sRGB bytes.
void encode(const Light& r, const Light& g, const Light& b, const std::vector<std::uint8_t>& codes,
            std::uint8_t* rgb) {
    for (std::size_t c = 0; c < 3; ++c) {
        const float light = r[c] + g[c] + b[c];
        rgb[c] = codes[std::size_t(light > 0 ? std::min(light, 1.0f) * top + 0.5f : 0.0f)];
    }
}

}  // namespace

void to_srgb(const LightTable& light, std::span<std::uint8_t> rgba) {
    constexpr std::size_t words = 257;  // 255 becomes 65535
    const auto& codes = srgb_codes();
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        encode(light[0][words * rgba[i]], light[1][words * rgba[i + 1]], light[2][words * rgba[i + 2]], codes,
               &rgba[i]);
}

std::vector<std::uint8_t> to_srgb(const LightTable& light, std::span<const std::uint16_t> rgba) {
    const auto& codes = srgb_codes();
    std::vector<std::uint8_t> out(rgba.size());
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        encode(light[0][rgba[i]], light[1][rgba[i + 1]], light[2][rgba[i + 2]], codes, &out[i]);
        out[i + 3] = std::uint8_t((rgba[i + 3] + 128u) / 257u);
    }
    return out;
}

}  // namespace vantage
