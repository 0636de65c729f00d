#include "pipeline/stages/coordinates/vertex_coordinates.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/values/simd.h"
#include "base/values/tiling.h"
#include "pipeline/stages/coordinates/binned_vertices.h"

namespace vantage {
namespace {

/// Coordinates relative to a corner are exact in single precision if the triangle is at most this wide and
/// high.
constexpr int small_extent = 62 << position_bits;

/// The bins that a range of positions touches.
template <class Int>
std::pair<int, int> bins(Int low, Int high, int count) {
    return {int(std::clamp<Int>(low >> BinnedVertices::bin_bits, 0, count)),
            int(std::clamp<Int>(high >> BinnedVertices::bin_bits, -1, count - 1))};
}

/// A small triangle after setup, relative to its first corner.
struct SmallTriangle {
    int x, y;                      ///< position of the first corner
    int left, right, top, bottom;  ///< bounds of the positions that the triangle may hide
    float bx, by, cx, cy, area;
    float slack;  ///< keeps rounding from opening gaps between triangles
    float sign, share;
    float inverse[3];   ///< 1/z of the corners
    float max_inverse;  ///< vertices with a larger 1/z are not hidden
    int corners[3];
};

enum class Size { none, small, large };

VANTAGE_INLINE Size set_up(std::span<const ProjectedVertex> vertices, const std::uint32_t* corners,
                           float max_depth_ratio, SmallTriangle& t) {
    const ProjectedVertex a = vertices[corners[0]], b = vertices[corners[1]], c = vertices[corners[2]];
    const float min_inverse = std::min(std::min(a.inverse, b.inverse), c.inverse),
                max_inverse = std::max(std::max(a.inverse, b.inverse), c.inverse);
    t.left = std::min(std::min(a.x, b.x), c.x), t.right = std::max(std::max(a.x, b.x), c.x);
    t.top = std::min(std::min(a.y, b.y), c.y), t.bottom = std::max(std::max(a.y, b.y), c.y);
    if (!(min_inverse > 0) || std::int64_t(t.right) - t.left > small_extent ||
        std::int64_t(t.bottom) - t.top > small_extent)
        return Size::large;
    t.x = a.x, t.y = a.y;
    t.bx = float(b.x - a.x), t.by = float(b.y - a.y), t.cx = float(c.x - a.x), t.cy = float(c.y - a.y);
    t.area = t.bx * t.cy - t.by * t.cx;
    const float extent = float(std::max(t.right - t.left, t.bottom - t.top));
    t.slack = 4e-7f * extent * extent;
    t.sign = t.area > 0 ? 1 : -1;
    t.share = max_depth_ratio / t.area;
    t.max_inverse = max_inverse * max_depth_ratio;
    const float inverse[3] = {a.inverse, b.inverse, c.inverse};
    for (int i = 0; i < 3; ++i) t.inverse[i] = inverse[i], t.corners[i] = int(corners[i]);
    return std::abs(t.area) > t.slack ? Size::small : Size::none;
}

/// Tests `lanes` vertices, starting at `i`. Returns whether any of them is newly hidden.
VANTAGE_INLINE bool hide_lanes(const SmallTriangle& t, std::size_t i, BinnedVertices& s) {
    Ints x, y, vertex, hidden;
    Floats inverse;
    load(x, &s.x[i]);
    load(y, &s.y[i]);
    load(vertex, &s.vertex[i]);
    load(hidden, &s.hidden[i]);
    load(inverse, &s.inverse[i]);
    const Floats px = __builtin_convertvector(x - t.x, Floats), py = __builtin_convertvector(y - t.y, Floats);
    const Floats of_b = px * t.cy - py * t.cx, of_c = py * t.bx - px * t.by, of_a = t.area - of_b - of_c;
    const Ints inside =
        (of_a * t.sign >= -t.slack) & (of_b * t.sign >= -t.slack) & (of_c * t.sign >= -t.slack);
    const Ints other = (vertex != t.corners[0]) & (vertex != t.corners[1]) & (vertex != t.corners[2]);
    Floats nearest = (of_a * t.inverse[0] + of_b * t.inverse[1] + of_c * t.inverse[2]) * t.share;
    nearest = nearest > t.max_inverse ? Floats{} + t.max_inverse : nearest;
    const Ints found = inside & other & (nearest > inverse) & ~hidden;
    hidden |= found;
    store(hidden, &s.hidden[i]);
    std::uint64_t any[sizeof found / 8];
    std::memcpy(any, &found, sizeof found);
    return any[0] | any[1] | any[2] | any[3];
}

/// Among the `lanes` blocks that start at `first`, those in which the triangle may hide vertices: one bit in
/// each block's byte.
VANTAGE_INLINE std::uint64_t blocks_behind(const SmallTriangle& t, std::size_t first, const VertexBlocks& b) {
    Ints left, right, top, bottom;
    Floats inverse;
    load(left, &b.left[first]);
    load(right, &b.right[first]);
    load(top, &b.top[first]);
    load(bottom, &b.bottom[first]);
    load(inverse, &b.inverse[first]);
    const Ints behind = (left <= t.right) & (right >= t.left) & (top <= t.bottom) & (bottom >= t.top) &
                        (inverse < t.max_inverse);
    using Bytes = std::int8_t __attribute__((vector_size(lanes)));
    return std::bit_cast<std::uint64_t>(__builtin_convertvector(behind & 1, Bytes));
}

/// Hides vertices from `first` to `last` (inclusive), and possibly others, by descending through the levels
/// of blocks. Returns the number of tests; each covers `lanes` vertices or blocks.
VANTAGE_INLINE std::size_t hide_in_blocks(const SmallTriangle& t, std::size_t first, std::size_t last,
                                          BinnedVertices& s) {
    struct Group {
        std::size_t level, first;  ///< the first of `lanes` blocks
    };
    // A level leaves at most lanes - 1 groups on the stack; vertices are indexed with 32 bits.
    std::array<Group, 11 * lanes> open;
    constexpr int shift = std::countr_zero(unsigned(lanes));
    std::size_t level = 0;
    first >>= 2 * shift, last >>= 2 * shift;
    for (; first != last; ++level) first >>= shift, last >>= shift;
    std::size_t count = 0, tests = 0;
    open[count++] = {level, first << shift};
    while (count) {
        const Group g = open[--count];
        ++tests;
        for (std::uint64_t bits = blocks_behind(t, g.first, s.levels[g.level]); bits; bits &= bits - 1) {
            const std::size_t block = g.first + std::size_t(std::countr_zero(bits) / 8);
            if (g.level) {
                open[count++] = {g.level - 1, block << shift};
                continue;
            }
            ++tests;
            if (hide_lanes(t, block << shift, s)) s.update_depth(block);
        }
    }
    return tests;
}

/// Widens the bounds, within these bins, because the slack enlarges the triangle.
VANTAGE_INLINE void add_slack(SmallTriangle& t, int x0, int x1, int y0, int y1) {
    // A barycentric coordinate is at least -slack / area; the factor also covers rounding.
    const float reach = 8 * t.slack / std::abs(t.area);
    const auto wider = [&](int& low, int& high, int bin0, int bin1) {
        const auto margin = std::int64_t(reach * float(high - low)) + 1;
        const std::int64_t begin = std::int64_t(bin0) << BinnedVertices::bin_bits,
                           end = (std::int64_t(bin1) + 1) << BinnedVertices::bin_bits;
        low = int(std::max(low - margin, begin));
        high = int(std::min(high + margin, end - 1));
    };
    wider(t.left, t.right, x0, x1);
    wider(t.top, t.bottom, y0, y1);
}

/// Marks the vertices hidden by small triangles. A triangle hides a vertex if the vertex is not one of its
/// corners and the line of sight meets the triangle at less than `max_depth_ratio` times the vertex's depth.
/// Returns the indices of the large triangles.
VANTAGE_SIMD std::vector<std::uint32_t> hide_by_small(std::span<const ProjectedVertex> vertices,
                                                      std::span<const std::uint32_t> indices,
                                                      float max_depth_ratio, BinnedVertices& s,
                                                      std::uint64_t& tests) {
    std::vector<std::uint32_t> large;
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) {
        SmallTriangle triangle;
        const Size size = set_up(vertices, &indices[3 * t], max_depth_ratio, triangle);
        if (size == Size::large) large.push_back(std::uint32_t(t));
        if (size != Size::small) continue;
        const auto [x0, x1] = bins(triangle.left, triangle.right, s.columns);
        const auto [y0, y1] = bins(triangle.top, triangle.bottom, s.rows);
        if (x0 > x1 || y0 > y1) continue;
        const auto row = [&](int y) { return &s.first[std::size_t(y) * std::size_t(s.columns)]; };
        std::size_t in_rows = 0;
        for (int y = y0; y <= y1; ++y) in_rows += row(y)[x1 + 1] - row(y)[x0];
        if (in_rows > BinnedVertices::crowded * std::size_t(y1 - y0 + 1)) {
            add_slack(triangle, x0, x1, y0, y1);
            tests += hide_in_blocks(triangle, row(y0)[x0], row(y1)[x1 + 1] - 1, s);
            continue;
        }
        for (int y = y0; y <= y1; ++y)
            for (std::size_t i = row(y)[x0]; i < row(y)[x1 + 1]; i += std::size_t(lanes), ++tests)
                hide_lanes(triangle, i, s);
    }
    return large;
}

/// Marks the vertices hidden by one clipped triangle of any size.
void hide_by(const ProjectedPiece& p, const std::uint32_t* corners, double max_depth_ratio,
             BinnedVertices& s) {
    const auto edge = [&](std::size_t a, std::size_t b, double x, double y) {
        return double(p.x[b] - p.x[a]) * (y - double(p.y[a])) -
               double(p.y[b] - p.y[a]) * (x - double(p.x[a]));
    };
    const auto [x0, x1] = bins(std::ranges::min(p.x), std::ranges::max(p.x), s.columns);
    const auto [y0, y1] = bins(std::ranges::min(p.y), std::ranges::max(p.y), s.rows);
    if (x0 > x1) return;
    for (int y = y0; y <= y1; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(s.columns);
        for (std::size_t i = s.first[row + std::size_t(x0)]; i < s.first[row + std::size_t(x1) + 1]; ++i) {
            const double x_i = s.x[i], y_i = s.y[i];
            const double u = edge(1, 2, x_i, y_i), v = edge(2, 0, x_i, y_i), w = edge(0, 1, x_i, y_i),
                         area = u + v + w;
            if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || area == 0) continue;
            if (std::count(corners, corners + 3, std::uint32_t(s.vertex[i]))) continue;
            const double nearest = p.clamped((u * p.inverse[0] + v * p.inverse[1] + w * p.inverse[2]) / area);
            if (nearest * max_depth_ratio > double(s.inverse[i])) s.hidden[i] = -1;
        }
    }
}

}  // namespace

std::vector<Eigen::Vector2f> vertex_coordinates(const PhotoProjection& projection,
                                                std::span<const std::uint32_t> indices,
                                                const Intrinsics& photo, std::uint64_t* tests) {
    const double max_depth_ratio = 1 - 0.3 / std::max(photo.fx, photo.fy);
    BinnedVertices binned = bin_vertices(projection);
    std::uint64_t count = 0;
    for (const std::uint32_t t :
         hide_by_small(projection.vertices, indices, float(max_depth_ratio), binned, count)) {
        const std::uint32_t* corners = &indices[3 * std::size_t(t)];
        for (const ProjectedPiece& piece : clipped(projection, corners))
            hide_by(piece, corners, max_depth_ratio, binned);
    }
    if (tests) *tests = count;
    std::vector<Eigen::Vector2f> out(projection.vertices.size(), Eigen::Vector2f(-1, -1));
    // Fixed-point positions are finer than single-precision texture coordinates.
    const double pixel = double(1 << weight_map_level) / (1 << position_bits), x = pixel / photo.width,
                 y = pixel / photo.height;
    for (std::size_t i = 0; i < binned.first.back(); ++i)
        if (const Eigen::Vector2d at(binned.x[i] * x, binned.y[i] * y);
            !binned.hidden[i] && at.maxCoeff() < 1)
            out[std::size_t(binned.vertex[i])] = at.cast<float>();
    return out;
}

}  // namespace vantage
