#include "scene/pinhole_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "scene/halve.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

using Weights = std::array<float, 4>;

/// Of four texels, for a place `f` of the way from the second to the third.
Weights catmull_rom(float f) {
    const float f2 = f * f, f3 = f2 * f;
    return {(-f3 + 2 * f2 - f) / 2, (3 * f3 - 5 * f2 + 2) / 2, (-3 * f3 + 4 * f2 + f) / 2, (f3 - f2) / 2};
}

/// Red, green, blue and alpha.
using Color = float __attribute__((vector_size(16)));
using Colors = std::array<Color, 4>;

/// Four texels, of 16 bytes.
Colors colors_of(const std::uint8_t* texels) {
#ifdef __SSE2__
    const __m128i zero = _mm_setzero_si128(),
                  bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(texels)),
                  low = _mm_unpacklo_epi8(bytes, zero), high = _mm_unpackhi_epi8(bytes, zero);
    return {_mm_cvtepi32_ps(_mm_unpacklo_epi16(low, zero)), _mm_cvtepi32_ps(_mm_unpackhi_epi16(low, zero)),
            _mm_cvtepi32_ps(_mm_unpacklo_epi16(high, zero)), _mm_cvtepi32_ps(_mm_unpackhi_epi16(high, zero))};
#else
    Colors out;
    for (int i = 0; i < 16; ++i) out[std::size_t(i / 4)][i % 4] = texels[i];
    return out;
#endif
}

/// Texels x to x + 3 of a row; beyond its ends, its last ones.
Colors four_texels(const std::uint8_t* row, int x, int width) {
    if (x >= 0 && x + 4 <= width) return colors_of(row + 4 * x);
    std::array<std::uint8_t, 16> edge;
    for (int i = 0; i < 4; ++i)
        std::memcpy(&edge[std::size_t(4 * i)], row + 4 * std::clamp(x + i, 0, width - 1), 4);
    return colors_of(edge.data());
}

/// Writes the color at a place in texels, from the 16 around it, weighted by their alpha.
template <bool Opaque>
void sample(const RgbaImage& image, const Eigen::Vector2f& at, std::uint8_t* to) {
    const float x = std::floor(at.x() - 0.5f), y = std::floor(at.y() - 0.5f);
    const Weights wx = catmull_rom(at.x() - 0.5f - x), wy = catmull_rom(at.y() - 0.5f - y);
    Color sum{};
    for (int j = 0; j < 4; ++j) {
        const int row = std::clamp(int(y) - 1 + j, 0, image.height - 1);
        const Colors four = four_texels(&image.rgba[4 * std::size_t(row) * std::size_t(image.width)],
                                        int(x) - 1, image.width);
        const auto weighted = [](float w, Color c) {
            if constexpr (!Opaque) w *= c[3], c[3] = 1;
            return w * c;
        };
        sum += wy[std::size_t(j)] * (weighted(wx[0], four[0]) + weighted(wx[1], four[1]) +
                                     weighted(wx[2], four[2]) + weighted(wx[3], four[3]));
    }
    if constexpr (!Opaque) {
        if (!(sum[3] >= 1)) return;
        const float alpha = sum[3];
        sum /= alpha;
        sum[3] = alpha;
    }
    for (int c = 0; c < 4; ++c) to[c] = std::uint8_t(std::clamp(sum[c] + 0.5f, 0.0f, 255.0f));
}

/// The table's coefficients for a row of texels: its four rows, weighted.
void weigh_rows(const LensTable& table, const SplinePlace& y, std::vector<Eigen::Vector2f>& out) {
    for (std::size_t i = 0; i < std::size_t(LensTable::side); ++i) {
        out[i].setZero();
        for (std::size_t j = 0; j < 4; ++j)
            out[i] += y.weights[j] * table.displaced[(std::size_t(y.first) + j) * LensTable::side + i];
    }
}

}  // namespace

RgbaImage pinhole_image(const RgbaImage& photo, const LensTable& table, int level) {
    const Intrinsics& k = table.camera;
    const Level size = level_size(k.width, k.height, level);
    if (photo.width != size.width || photo.height != size.height)
        throw std::invalid_argument("a photo does not have the size of its level");
    const double texel = 1 << level;
    const Eigen::Vector2f high(float(k.width / texel), float(k.height / texel));
    std::vector<SplinePlace> columns;
    for (int x = 0; x < size.width; ++x) columns.push_back(spline_place((x + 0.5) * texel / k.width));
    std::vector<Eigen::Vector2f> row(LensTable::side);
    RgbaImage out = blank_image(size.width, size.height);
    const auto sample_at = is_opaque(photo) ? sample<true> : sample<false>;
    for (int y = 0; y < size.height; ++y) {
        const double v = (y + 0.5) * texel;
        weigh_rows(table, spline_place(v / k.height), row);
        for (int x = 0; x < size.width; ++x) {
            const double u = (x + 0.5) * texel;
            const double a = (u - k.cx) / k.fx, b = (v - k.cy) / k.fy;
            if (!(a * a + b * b <= table.range * table.range)) continue;
            const SplinePlace& p = columns[std::size_t(x)];
            Eigen::Vector2f moved = Eigen::Vector2f::Zero();
            for (std::size_t i = 0; i < 4; ++i) moved += p.weights[i] * row[std::size_t(p.first) + i];
            const Eigen::Vector2f at =
                Eigen::Vector2f(float(x) + 0.5f, float(y) + 0.5f) + moved / float(texel);
            if ((at.array() < 0).any() || (at.array() > high.array()).any()) continue;
            sample_at(photo, at, &out.rgba[4 * (std::size_t(y) * std::size_t(size.width) + std::size_t(x))]);
        }
    }
    return out;
}

}  // namespace vantage
