#include "base/values/halve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/values/grid.h"
#include "base/values/srgb.h"
#include "base/values/tiling.h"

namespace vantage {
namespace {

constexpr int linear_bits = 14;

/// Tables that convert sRGB bytes to 14-bit linear light, and back.
struct SrgbTables {
    std::array<std::uint16_t, 256> linear;
    std::vector<std::uint8_t> srgb;
    SrgbTables() : srgb((1 << linear_bits) + 1) {
        const double top = 1 << linear_bits;
        for (std::size_t i = 0; i < linear.size(); ++i)
            linear[i] = std::uint16_t(std::lround(top * linear_of_srgb_byte()[i]));
        for (std::size_t i = 0; i < srgb.size(); ++i)
            srgb[i] = std::uint8_t(std::lround(255 * srgb_from_linear(double(i) / top)));
    }
};
const SrgbTables& tables() {
    static const SrgbTables t;
    return t;
}

void average_opaque(const std::uint8_t* const (&q)[4], std::uint8_t* out, const SrgbTables& t) {
    for (int c = 0; c < 3; ++c)
        out[c] = t.srgb[(unsigned(t.linear[q[0][c]]) + t.linear[q[1][c]] + t.linear[q[2][c]] +
                         t.linear[q[3][c]] + 2) /
                        4];
    out[3] = 255;
}

void average(const std::uint8_t* const (&q)[4], std::uint8_t* out, const SrgbTables& t) {
    const unsigned alpha = unsigned(q[0][3]) + q[1][3] + q[2][3] + q[3][3];
    if (alpha == 4 * 255) return average_opaque(q, out, t);
    out[3] = std::uint8_t((alpha + 2) / 4);
    for (int c = 0; c < 3; ++c) {
        std::uint32_t sum = 0;
        for (const std::uint8_t* p : q) sum += std::uint32_t(t.linear[p[c]]) * p[3];
        out[c] = t.srgb[alpha ? (sum + alpha / 2) / alpha : 0];
    }
}

template <auto Average>
void halve_row(const std::uint8_t* a, const std::uint8_t* b, int width, int half, std::uint8_t* to) {
    const SrgbTables& t = tables();
    for (int x = 0; x < half; ++x) {
        const int l = 8 * x, r = 2 * x + 1 < width ? l + 4 : l;
        Average({a + l, a + r, b + l, b + r}, to + 4 * x, t);
    }
}

}  // namespace

bool is_opaque(std::span<const std::byte> rgba) {
    std::uint32_t all = ~0u;
    for (std::size_t i = 0; i + 4 <= rgba.size(); i += 4) {
        std::uint32_t texel;
        std::memcpy(&texel, &rgba[i], 4);
        all &= texel;
    }
    std::uint8_t bytes[4];
    std::memcpy(bytes, &all, 4);
    return bytes[3] == 255;
}

bool is_opaque(const RgbaImage& image) {
    return image.opaque || is_opaque(std::as_bytes(std::span(image.rgba)));
}

RgbaImage halve(const RgbaImage& image) {
    const Level half = level_size(image.width, image.height, 1);
    RgbaImage out = blank_image(half.width, half.height);
    out.opaque = image.opaque;
    const Grid<const std::uint8_t> from{image.rgba.data(), 4 * image.width, image.height};
    const Grid<std::uint8_t> to{out.rgba.data(), 4 * half.width, half.height};
    const auto halve_rows = image.opaque ? halve_row<average_opaque> : halve_row<average>;
    for (int y = 0; y < half.height; ++y) {
        const std::span a = from.row(2 * y), b = from.row(std::min(2 * y + 1, image.height - 1));
        halve_rows(a.data(), b.data(), image.width, half.width, to.row(y).data());
    }
    return out;
}

}  // namespace vantage
