#include "pipeline/visibility/triangle_map.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "base/values/simd.h"

namespace vantage {
namespace {

constexpr int subpixel_bits = 8;
constexpr int subpixels = 1 << subpixel_bits;
/// Up to this extent, in subpixels, edge functions fit in 32 bits.
constexpr int small_extent = 62 * subpixels;

template <class Int>
Int snapped(Int position) {
    constexpr int shift = position_bits - subpixel_bits;
    return (position + (Int(1) << (shift - 1))) >> shift;
}

/// The first and last pixel of the map whose centers lie in [low, high] (subpixels); none if first > last.
template <class Int>
std::pair<int, int> pixel_centers(Int low, Int high, int size) {
    constexpr Int half = subpixels / 2;
    return {int(std::clamp<Int>((low + half - 1) >> subpixel_bits, 0, size)),
            int(std::clamp<Int>((high - half) >> subpixel_bits, -1, size - 1))};
}

/// Triangles after setup, in groups of `lanes`. Edge function i, opposite corner i, is nonnegative inside the
/// triangle; 1/z and value/z are linear over the map.
struct SmallTriangles {
    Ints small;           ///< -1 for small triangles; otherwise, the fields after `large` are undefined
    Ints large;           ///< -1 for large triangles
    Ints x0, x1, y0, y1;  ///< bounding box, pixels; may be empty
    Ints row[3], step_x[3], step_y[3];
    Floats min_inverse, max_inverse;  ///< bounds of 1/z
    Doubles inverse, inverse_x, inverse_y;
    Floats value, value_x, value_y;
};

VANTAGE_INLINE Ints snapped(const Ints& position) {
    constexpr int shift = position_bits - subpixel_bits;
    return (position + (1 << (shift - 1))) >> shift;
}

/// One corner of each triangle, on the map, in subpixels.
struct Corners {
    Ints x, y;
    Floats inverse, value;
};

VANTAGE_INLINE Corners corners(std::span<const ProjectedVertex> vertices, std::span<const float> values,
                               const std::uint32_t* indices) {
    Corners out;
    for (int i = 0; i < lanes; ++i) {
        const std::uint32_t v = indices[3 * i];
        out.x[i] = vertices[v].x, out.y[i] = vertices[v].y;
        out.inverse[i] = vertices[v].inverse, out.value[i] = values[v];
    }
    out.x = snapped(out.x), out.y = snapped(out.y);
    return out;
}

VANTAGE_INLINE SmallTriangles set_up(const Corners (&p)[3], int width, int height) {
    SmallTriangles s;
    s.min_inverse = least(least(p[0].inverse, p[1].inverse), p[2].inverse);
    s.max_inverse = greatest(greatest(p[0].inverse, p[1].inverse), p[2].inverse);
    const Ints left = least(least(p[0].x, p[1].x), p[2].x),
               right = greatest(greatest(p[0].x, p[1].x), p[2].x), top = least(least(p[0].y, p[1].y), p[2].y),
               bottom = greatest(greatest(p[0].y, p[1].y), p[2].y);
    s.large = ~((s.min_inverse > 0) & (right - left <= small_extent) & (bottom - top <= small_extent));
    constexpr int half = subpixels / 2;
    const auto first = [](const Ints& low, int size) {
        return greatest(least((low + half - 1) >> subpixel_bits, Ints{} + size), Ints{});
    };
    const auto last = [](const Ints& high, int size) {
        return greatest(least((high - half) >> subpixel_bits, Ints{} + (size - 1)), Ints{} - 1);
    };
    s.x0 = first(left, width), s.x1 = last(right, width);
    s.y0 = first(top, height), s.y1 = last(bottom, height);
    const Ints area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    s.small = ~s.large & (s.x0 <= s.x1) & (s.y0 <= s.y1) & (area != 0);
    const Ints negative = area < 0;
    const auto with_sign = [&](const Ints& v) { return negative ? -v : v; };
    const Ints cx = s.x0 * subpixels + half, cy = s.y0 * subpixels + half;
    const Doubles share = 1 / __builtin_convertvector(with_sign(area), Doubles);
    s.inverse = s.inverse_x = s.inverse_y = Doubles{};
    s.value = s.value_x = s.value_y = Floats{};
    for (int i = 0; i < 3; ++i) {
        const Corners &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
        const Ints dx = with_sign(b.x - a.x), dy = with_sign(b.y - a.y);
        s.row[i] = dx * (cy - a.y) - dy * (cx - a.x);
        s.step_x[i] = -dy * subpixels;
        s.step_y[i] = dx * subpixels;
        const Doubles depth = __builtin_convertvector(p[i].inverse, Doubles) * share;
        s.inverse += __builtin_convertvector(s.row[i], Doubles) * depth;
        s.inverse_x += __builtin_convertvector(s.step_x[i], Doubles) * depth;
        s.inverse_y += __builtin_convertvector(s.step_y[i], Doubles) * depth;
        const Floats value = __builtin_convertvector(depth, Floats) * p[i].value;
        s.value += __builtin_convertvector(s.row[i], Floats) * value;
        s.value_x += __builtin_convertvector(s.step_x[i], Floats) * value;
        s.value_y += __builtin_convertvector(s.step_y[i], Floats) * value;
    }
    return s;
}

/// Fills triangle `i`, eight pixels of a row at a time.
VANTAGE_INLINE void fill(const SmallTriangles& s, int i, std::uint32_t t, TriangleMap& map) {
    constexpr Ints lane{0, 1, 2, 3, 4, 5, 6, 7};
    constexpr Floats lane_f{0, 1, 2, 3, 4, 5, 6, 7};
    const Ints number = Ints{} + int(t);
    const auto width = std::size_t(map.width);
    float *depths = map.inverse_depth.data(), *values = map.value.data();
    std::uint32_t* triangles = map.triangles.data();
    const int x0 = s.x0[i], x1 = s.x1[i], y0 = s.y0[i], y1 = s.y1[i];
    const Floats least_inverse = Floats{} + s.min_inverse[i], max_inverse = Floats{} + s.max_inverse[i];
    const Floats slope = lane_f * float(s.inverse_x[i]);
    const double inverse_y = s.inverse_y[i];
    for (int x = x0; x <= x1; x += lanes) {
        const int along = x - x0;
        Ints a = lane * s.step_x[0][i] + (s.row[0][i] + along * s.step_x[0][i]),
             b = lane * s.step_x[1][i] + (s.row[1][i] + along * s.step_x[1][i]),
             c = lane * s.step_x[2][i] + (s.row[2][i] + along * s.step_x[2][i]);
        const Ints in_bounds = lane <= x1 - x;
        double plane = s.inverse[i] + along * s.inverse_x[i];
        Floats value = lane_f * s.value_x[i] + (s.value[i] + float(along) * s.value_x[i]);
        std::size_t at = std::size_t(y0) * width + std::size_t(x);
        for (int y = y0; y <= y1; ++y, at += width) {
            Floats depth, shown;
            Ints triangle;
            load(depth, depths + at);
            load(shown, values + at);
            load(triangle, triangles + at);
            // Clamped to the range of the corners, because interpolation loses precision on slivers.
            const Floats inverse = least(greatest(slope + float(plane), least_inverse), max_inverse);
            const Ints seen = ((a | b | c) >= 0) & in_bounds & (inverse > depth);
            depth = seen ? inverse : depth;
            shown = seen ? value : shown;
            triangle = seen ? number : triangle;
            store(depth, depths + at);
            store(shown, values + at);
            store(triangle, triangles + at);
            a += s.step_y[0][i], b += s.step_y[1][i], c += s.step_y[2][i];
            plane += inverse_y;
            value += s.value_y[i];
        }
    }
}

/// Fills small triangles and returns the indices of the large ones.
VANTAGE_SIMD std::vector<std::uint32_t> fill_small(std::span<const ProjectedVertex> vertices,
                                                   std::span<const std::uint32_t> indices,
                                                   std::span<const float> values, TriangleMap& map) {
    std::vector<std::uint32_t> large;
    const std::size_t count = indices.size() / 3;
    std::uint32_t last[3 * lanes] = {};  // followed by degenerate triangles
    for (std::size_t t = 0; t < count; t += std::size_t(lanes)) {
        const std::size_t n = std::min(count - t, std::size_t(lanes));
        const std::uint32_t* v = &indices[3 * t];
        if (n < std::size_t(lanes)) std::copy_n(std::exchange(v, last), 3 * n, last);
        const SmallTriangles s = set_up({corners(vertices, values, v), corners(vertices, values, v + 1),
                                         corners(vertices, values, v + 2)},
                                        map.width, map.height);
        for (std::size_t i = 0; i < n; ++i) {
            if (s.small[i]) fill(s, int(i), std::uint32_t(t + i), map);
            if (s.large[i]) large.push_back(std::uint32_t(t + i));
        }
    }
    return large;
}

/// Fills a triangle of any size.
void fill(ProjectedPiece p, std::uint32_t number, TriangleMap& map) {
    for (std::size_t i = 0; i < 3; ++i) p.x[i] = snapped(p.x[i]), p.y[i] = snapped(p.y[i]);
    const auto [x0, x1] = pixel_centers(std::ranges::min(p.x), std::ranges::max(p.x), map.width);
    const auto [y0, y1] = pixel_centers(std::ranges::min(p.y), std::ranges::max(p.y), map.height);
    if (x0 > x1 || y0 > y1) return;
    const double area =
        double(p.x[1] - p.x[0]) * double(p.y[2] - p.y[0]) - double(p.y[1] - p.y[0]) * double(p.x[2] - p.x[0]);
    if (area == 0) return;
    const double sign = area > 0 ? 1 : -1;
    double step_x[3], step_y[3], row[3], inverse_row = 0, inverse_x = 0, inverse_y = 0;
    const std::int64_t cx = std::int64_t(x0) * subpixels + subpixels / 2,
                       cy = std::int64_t(y0) * subpixels + subpixels / 2;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
        const double dx = sign * double(p.x[b] - p.x[a]), dy = sign * double(p.y[b] - p.y[a]);
        const double share = p.inverse[i] / (sign * area);
        row[i] = dx * double(cy - p.y[a]) - dy * double(cx - p.x[a]);
        step_x[i] = -dy * subpixels;
        step_y[i] = dx * subpixels;
        inverse_row += row[i] * share;
        inverse_x += step_x[i] * share;
        inverse_y += step_y[i] * share;
    }
    for (int y = y0; y <= y1; ++y) {
        double a = row[0], b = row[1], c = row[2], plane = inverse_row;
        const std::size_t start = std::size_t(y) * std::size_t(map.width);
        float *depth = &map.inverse_depth[start], *value = &map.value[start];
        std::uint32_t* shown = &map.triangles[start];
        for (int x = x0; x <= x1; ++x) {
            const auto inverse = float(p.clamped(plane));
            if (std::min(std::min(a, b), c) >= 0 && inverse > depth[x]) {
                depth[x] = inverse;
                shown[x] = number;
                value[x] = std::numeric_limits<float>::quiet_NaN();
            }
            a += step_x[0], b += step_x[1], c += step_x[2];
            plane += inverse_x;
        }
        for (std::size_t i = 0; i < 3; ++i) row[i] += step_y[i];
        inverse_row += inverse_y;
    }
}

}  // namespace

TriangleMap rasterize(const PhotoProjection& projection, std::span<const std::uint32_t> indices,
                      std::span<const float> values) {
    const Intrinsics& k = projection.intrinsics;
    // Vector stores may write past the end of the last row.
    const std::size_t pixels = std::size_t(k.width) * std::size_t(k.height), padded = pixels + lanes;
    TriangleMap map{k.width, k.height, std::vector<float>(padded, 0.0f),
                    std::vector<std::uint32_t>(padded, TriangleMap::none), std::vector<float>(padded, 0.0f)};
    for (const std::uint32_t t : fill_small(projection.vertices, indices, values, map))
        for (const ProjectedPiece& piece : clipped(projection, &indices[3 * std::size_t(t)]))
            fill(piece, t, map);
    map.inverse_depth.resize(pixels);
    map.triangles.resize(pixels);
    map.value.resize(pixels);
    return map;
}

}  // namespace vantage
