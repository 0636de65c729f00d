#include "scene/package/contents/pinhole_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "base/values/simd.h"
#include "base/values/tiling.h"

namespace vantage {
namespace {

constexpr int reach = 2;       ///< radius of the interpolation in texels
constexpr int band_rows = 64;  ///< number of rows converted and sampled at a time

/// Rows of an image as numbers, with premultiplied alpha. The rows are padded with the edge texels as far as
/// the interpolation reaches.
struct Texels {
    int first_row, width;  ///< width of a row in texels
    std::vector<float> values;

    /// The four channels of a texel of the image.
    VANTAGE_INLINE const float* at(int x, int y) const {
        return values.data() + 4 * (std::size_t(y - first_row) * std::size_t(width) + std::size_t(x + reach));
    }
};

VANTAGE_SIMD void convert_row(const std::uint8_t* from, int texels, float* to) {
    for (int i = 0; i < 4 * texels; i += 4) {
        const float alpha = from[i + 3];
        for (int c = 0; c < 3; ++c) to[i + c] = alpha * float(from[i + c]);
        to[i + 3] = alpha;
    }
}

Texels texels_of(const RgbaImage& image, int first_row, int last_row) {
    Texels out{first_row, image.width + 2 * reach, {}};
    const auto row = 4 * std::size_t(out.width);
    out.values.resize(row * std::size_t(last_row - first_row + 1));
    for (int y = first_row; y <= last_row; ++y) {
        const int inside = std::clamp(y, 0, image.height - 1);
        float* to = out.values.data() + row * std::size_t(y - first_row);
        convert_row(&image.rgba[4 * std::size_t(inside) * std::size_t(image.width)], image.width,
                    to + 4 * reach);
        for (int i = 0; i < reach; ++i) {
            std::copy_n(to + 4 * reach, 4, to + 4 * i);
            std::copy_n(to + row - 4 * (reach + 1), 4, to + row - 4 * (i + 1));
        }
    }
    return out;
}

/// The red, green, blue and alpha of one texel, and of two adjacent texels.
using Color = float __attribute__((vector_size(16)));
using Pair = Floats;
static_assert(lanes == 8);

/// Catmull-Rom weights of four texels, for a position at fraction `f` between the second and the third.
template <class Vector>
VANTAGE_INLINE Vector catmull_rom(float f, const Vector& cube, const Vector& square, const Vector& linear,
                                  const Vector& constant) {
    return ((cube * f + square) * f + linear) * f + constant;
}

VANTAGE_INLINE Pair both(float left, float right) {
    return Pair{left, left, left, left, right, right, right, right};
}

/// Writes the color at a position in texels, interpolated from the 16 texels around it.
VANTAGE_INLINE void sample(const Texels& texels, float x, float y, std::uint8_t* to) {
    const int column = int(x + 0.5f) - 1, row = int(y + 0.5f) - 1;  // floors: positions are not negative
    const float fx = x - 0.5f - float(column);
    const Pair left = catmull_rom(fx, both(-0.5f, 1.5f), both(1, -2.5f), both(-0.5f, 0), both(0, 1)),
               right = catmull_rom(fx, both(-1.5f, 0.5f), both(2, -0.5f), both(0.5f, 0), both(0, 0));
    const Color rows = catmull_rom(y - 0.5f - float(row), Color{-0.5f, 1.5f, -1.5f, 0.5f},
                                   Color{1, -2.5f, 2, -0.5f}, Color{-0.5f, 0, 0.5f, 0}, Color{0, 1, 0, 0});
    Pair sum{};
    for (int j = 0; j < 4; ++j) {
        const float* four = texels.at(column - 1, row - 1 + j);
        Pair first, second;
        load(first, four);
        load(second, four + lanes);
        sum += rows[j] * (left * first + right * second);
    }
    Color halves[2];
    std::memcpy(halves, &sum, sizeof sum);
    const Color color = halves[0] + halves[1];
    const float alpha = color[3];
    if (!(alpha >= 1)) return;
    const Color bytes = color / Color{alpha, alpha, alpha, 1} + 0.5f;
    for (int c = 0; c < 4; ++c) to[c] = std::uint8_t(std::clamp(bytes[c], 0.0f, 255.0f));
}

/// The coefficients for a row of texels: a weighted sum of four rows of the table's coefficients.
void weigh_rows(const LensTable& table, const SplinePlace& y, std::vector<Eigen::Vector2f>& out) {
    for (std::size_t i = 0; i < std::size_t(LensTable::side); ++i) {
        out[i].setZero();
        for (std::size_t j = 0; j < 4; ++j)
            out[i] += y.weights[j] * table.displaced[(std::size_t(y.first) + j) * LensTable::side + i];
    }
}

struct Columns {
    std::vector<SplinePlace> places;  ///< positions in the table
    std::vector<double> squares;      ///< squares of the rays' horizontal components
};

/// A row of the pinhole camera's level.
struct LevelRow {
    int y;
    float texel;                                ///< size of a texel in pixels of the photo
    double square;                              ///< square of the rays' vertical component
    const std::vector<Eigen::Vector2f>& moves;  ///< the table's coefficients
};

VANTAGE_SIMD void sample_row(const Texels& texels, const LensTable& table, const Columns& columns,
                             const LevelRow& row, RgbaImage& out) {
    const auto [y, texel, square, moves] = row;
    const float right = float(table.camera.width) / texel, bottom = float(table.camera.height) / texel;
    const float share = 1 / texel;  // exact: a power of two
    const double most = table.range * table.range - square;
    std::uint8_t* to = &out.rgba[4 * std::size_t(y) * std::size_t(out.width)];
    for (int x = 0; x < out.width; ++x) {
        if (!(columns.squares[std::size_t(x)] <= most)) continue;
        const SplinePlace& p = columns.places[std::size_t(x)];
        float move_x = 0, move_y = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const Eigen::Vector2f& move = moves[std::size_t(p.first) + i];
            move_x += p.weights[i] * move.x(), move_y += p.weights[i] * move.y();
        }
        const float at_x = float(x) + 0.5f + move_x * share, at_y = float(y) + 0.5f + move_y * share;
        if (at_x >= 0 && at_y >= 0 && at_x <= right && at_y <= bottom) sample(texels, at_x, at_y, to + 4 * x);
    }
}

/// The rows of the photo's level that are sampled for rows of the pinhole camera's level.
Texels texels_of_band(const RgbaImage& photo, const LensTable& table, double texel, int first, int last) {
    const Eigen::AlignedBox2d band(Eigen::Vector2d(0, first * texel),
                                   Eigen::Vector2d(table.camera.width, (last + 1) * texel));
    const Eigen::AlignedBox2d to = photo_bounds(table, band);
    const auto row = [&](double pixel) {
        return int(std::floor(std::clamp(pixel / texel, 0.0, double(photo.height))));
    };
    return texels_of(photo, row(to.min().y()) - reach, row(to.max().y()) + reach);
}

}  // namespace

RgbaImage pinhole_image(const RgbaImage& photo, const LensTable& table, int level) {
    const Intrinsics& k = table.camera;
    const Level size = level_size(k.width, k.height, level);
    if (photo.width != size.width || photo.height != size.height)
        throw std::invalid_argument("a photo does not have the size of its level");
    const double texel = 1 << level;
    Columns columns;
    for (int x = 0; x < size.width; ++x) {
        const double u = (x + 0.5) * texel, a = (u - k.cx) / k.fx;
        columns.places.push_back(spline_place(u / k.width));
        columns.squares.push_back(a * a);
    }
    std::vector<Eigen::Vector2f> moves(LensTable::side);
    RgbaImage out = blank_image(size.width, size.height);
    for (int first = 0; first < size.height; first += band_rows) {
        const int end = std::min(first + band_rows, size.height);
        const Texels texels = texels_of_band(photo, table, texel, first, end - 1);
        for (int y = first; y < end; ++y) {
            const double v = (y + 0.5) * texel, b = (v - k.cy) / k.fy;
            weigh_rows(table, spline_place(v / k.height), moves);
            sample_row(texels, table, columns, {y, float(texel), b * b, moves}, out);
        }
    }
    return out;
}

}  // namespace vantage
