#include "pipeline/visibility/triangle_map.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "pipeline/pixels/simd.h"

namespace vantage {
namespace {

constexpr int subpixel_bits = 8;
constexpr int subpixels = 1 << subpixel_bits;
/// Up to this extent, in subpixels, edge functions fit in 32 bits.
constexpr int small_extent = 62 * subpixels;

/// A corner on the map, in subpixels.
struct Corner {
    std::int32_t x, y;
    float inverse;
};

template <class Int>
Int snapped(Int position) {
    constexpr int shift = position_bits - subpixel_bits;
    return (position + (Int(1) << (shift - 1))) >> shift;
}

Corner snapped(const ProjectedVertex& v) { return {snapped(v.x), snapped(v.y), v.inverse}; }

/// The first and last pixel of the map whose centers lie in [low, high] (subpixels); none if first > last.
template <class Int>
std::pair<int, int> pixel_centers(Int low, Int high, int size) {
    constexpr Int half = subpixels / 2;
    return {int(std::clamp<Int>((low + half - 1) >> subpixel_bits, 0, size)),
            int(std::clamp<Int>((high - half) >> subpixel_bits, -1, size - 1))};
}

/// A small triangle after setup. Edge function i, opposite corner i, is nonnegative inside the triangle; 1/z
/// and value/z are linear over the map.
struct SmallTriangle {
    int x0, x1, y0, y1;  ///< bounding box, pixels
    int row[3], step_x[3], step_y[3];
    float min_inverse, max_inverse;  ///< bounds of 1/z
    double inverse, inverse_x, inverse_y;
    float value, value_x, value_y;
    std::uint32_t number;
};

enum class Size { none, small, large };

VANTAGE_INLINE Size set_up(const Corner (&p)[3], const float (&values)[3], int width, int height,
                           SmallTriangle& s) {
    s.min_inverse = std::min(std::min(p[0].inverse, p[1].inverse), p[2].inverse);
    s.max_inverse = std::max(std::max(p[0].inverse, p[1].inverse), p[2].inverse);
    const int left = std::min(std::min(p[0].x, p[1].x), p[2].x),
              right = std::max(std::max(p[0].x, p[1].x), p[2].x),
              top = std::min(std::min(p[0].y, p[1].y), p[2].y),
              bottom = std::max(std::max(p[0].y, p[1].y), p[2].y);
    if (!(s.min_inverse > 0) || right - left > small_extent || bottom - top > small_extent)
        return Size::large;
    std::tie(s.x0, s.x1) = pixel_centers(left, right, width);
    std::tie(s.y0, s.y1) = pixel_centers(top, bottom, height);
    if (s.x0 > s.x1 || s.y0 > s.y1) return Size::none;
    const int area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (area == 0) return Size::none;
    const int sign = area > 0 ? 1 : -1;
    const int cx = s.x0 * subpixels + subpixels / 2, cy = s.y0 * subpixels + subpixels / 2;
    const double share = 1 / double(std::abs(area));
    s.inverse = s.inverse_x = s.inverse_y = 0;
    s.value = s.value_x = s.value_y = 0;
    for (int i = 0; i < 3; ++i) {
        const Corner &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
        const int dx = sign * (b.x - a.x), dy = sign * (b.y - a.y);
        s.row[i] = dx * (cy - a.y) - dy * (cx - a.x);
        s.step_x[i] = -dy * subpixels;
        s.step_y[i] = dx * subpixels;
        const double depth = double(p[i].inverse) * share;
        s.inverse += s.row[i] * depth;
        s.inverse_x += s.step_x[i] * depth;
        s.inverse_y += s.step_y[i] * depth;
        const float value = float(depth) * values[i];
        s.value += float(s.row[i]) * value;
        s.value_x += float(s.step_x[i]) * value;
        s.value_y += float(s.step_y[i]) * value;
    }
    return Size::small;
}

/// Fills eight pixels of a row at a time.
VANTAGE_INLINE void fill(const SmallTriangle& s, TriangleMap& map) {
    constexpr Ints lane{0, 1, 2, 3, 4, 5, 6, 7};
    constexpr Floats lane_f{0, 1, 2, 3, 4, 5, 6, 7};
    const Ints number = Ints{} + int(s.number);
    const Floats slope = lane_f * float(s.inverse_x);
    for (int x = s.x0; x <= s.x1; x += lanes) {
        const int along = x - s.x0;
        Ints a = lane * s.step_x[0] + (s.row[0] + along * s.step_x[0]),
             b = lane * s.step_x[1] + (s.row[1] + along * s.step_x[1]),
             c = lane * s.step_x[2] + (s.row[2] + along * s.step_x[2]);
        const Ints in_bounds = lane <= s.x1 - x;
        double plane = s.inverse + along * s.inverse_x;
        Floats value = lane_f * s.value_x + (s.value + float(along) * s.value_x);
        std::size_t at = std::size_t(s.y0) * std::size_t(map.width) + std::size_t(x);
        for (int y = s.y0; y <= s.y1; ++y, at += std::size_t(map.width)) {
            Floats depth, shown;
            Ints triangle;
            load(depth, &map.inverse_depth[at]);
            load(shown, &map.value[at]);
            load(triangle, &map.triangles[at]);
            Floats inverse = slope + float(plane);
            // Clamped to the range of the corners, because interpolation loses precision on slivers.
            inverse = inverse < s.min_inverse ? Floats{} + s.min_inverse : inverse;
            inverse = inverse > s.max_inverse ? Floats{} + s.max_inverse : inverse;
            const Ints seen = ((a | b | c) >= 0) & in_bounds & (inverse > depth);
            depth = seen ? inverse : depth;
            shown = seen ? value : shown;
            triangle = seen ? number : triangle;
            store(depth, &map.inverse_depth[at]);
            store(shown, &map.value[at]);
            store(triangle, &map.triangles[at]);
            a += s.step_y[0], b += s.step_y[1], c += s.step_y[2];
            plane += s.inverse_y;
            value += s.value_y;
        }
    }
}

/// Fills small triangles and returns the indices of the large ones.
VANTAGE_SIMD std::vector<std::uint32_t> fill_small(std::span<const ProjectedVertex> vertices,
                                                   std::span<const std::uint32_t> indices,
                                                   std::span<const float> values, TriangleMap& map) {
    std::vector<std::uint32_t> large;
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) {
        const std::uint32_t* v = &indices[3 * t];
        const Corner corners[3] = {snapped(vertices[v[0]]), snapped(vertices[v[1]]), snapped(vertices[v[2]])};
        SmallTriangle s;
        s.number = std::uint32_t(t);
        const Size size =
            set_up(corners, {values[v[0]], values[v[1]], values[v[2]]}, map.width, map.height, s);
        if (size == Size::small) fill(s, map);
        if (size == Size::large) large.push_back(s.number);
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
