#include "pipeline/stages/vertex_coordinates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "pipeline/pixels/simd.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

/// Coordinates relative to a corner of a triangle up to this extent are exact in single precision.
constexpr int small_extent = 62 << position_bits;

/// The vertices inside a map, sorted into square bins row by row, so that those in a range of bins of one row
/// are contiguous.
struct BinnedVertices {
    static constexpr int bin_bits = position_bits + 2;  ///< bins of 4x4 pixels
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> first;  ///< start of each bin, and the end of the last
    // One element per vertex, and `lanes` of padding that nothing hides.
    std::vector<std::int32_t> x, y, vertex, hidden;
    std::vector<float> inverse;
};

BinnedVertices bin_vertices(const PhotoProjection& p) {
    constexpr int pixels = 1 << (BinnedVertices::bin_bits - position_bits);
    BinnedVertices s;
    s.columns = (p.intrinsics.width + pixels - 1) / pixels;
    s.rows = (p.intrinsics.height + pixels - 1) / pixels;
    const auto in_frame = [&](const ProjectedVertex& v) {
        return v.inverse > 0 && v.x >= 0 && v.y >= 0 && v.x >> BinnedVertices::bin_bits < s.columns &&
               v.y >> BinnedVertices::bin_bits < s.rows;
    };
    const auto bin_of = [&](const ProjectedVertex& v) {
        return std::size_t(v.y >> BinnedVertices::bin_bits) * std::size_t(s.columns) +
               std::size_t(v.x >> BinnedVertices::bin_bits);
    };
    // Counting sort. Counts are shifted by two bins, so that first[bin + 1] is the insertion position while
    // filling and ends up as the start of bin + 1.
    s.first.assign(std::size_t(s.columns) * std::size_t(s.rows) + 2, 0);
    for (const ProjectedVertex& v : p.vertices)
        if (in_frame(v)) ++s.first[bin_of(v) + 2];
    for (std::size_t i = 2; i < s.first.size(); ++i) s.first[i] += s.first[i - 1];
    const std::size_t padded = s.first.back() + std::size_t(lanes);
    s.x.assign(padded, 0);
    s.y.assign(padded, 0);
    s.vertex.assign(padded, -1);
    s.hidden.assign(padded, 0);
    s.inverse.assign(padded, std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < p.vertices.size(); ++i) {
        const ProjectedVertex& v = p.vertices[i];
        if (!in_frame(v)) continue;
        const std::size_t at = s.first[bin_of(v) + 1]++;
        s.x[at] = v.x, s.y[at] = v.y, s.inverse[at] = v.inverse, s.vertex[at] = std::int32_t(i);
    }
    s.first.pop_back();
    return s;
}

/// The bins that a range of positions touches.
template <class Int>
std::pair<int, int> bins(Int low, Int high, int count) {
    return {int(std::clamp<Int>(low >> BinnedVertices::bin_bits, 0, count)),
            int(std::clamp<Int>(high >> BinnedVertices::bin_bits, -1, count - 1))};
}

/// Marks the vertices hidden by small triangles: those whose line of sight meets a triangle that does not
/// contain them at less than `max_depth_ratio` of their depth. Returns the indices of the large triangles.
VANTAGE_SIMD std::vector<std::uint32_t> hide_by_small(std::span<const ProjectedVertex> vertices,
                                                      std::span<const std::uint32_t> indices,
                                                      float max_depth_ratio, BinnedVertices& s) {
    std::vector<std::uint32_t> large;
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) {
        const std::uint32_t* corners = &indices[3 * t];
        const ProjectedVertex a = vertices[corners[0]], b = vertices[corners[1]], c = vertices[corners[2]];
        const float min_inverse = std::min(std::min(a.inverse, b.inverse), c.inverse),
                    max_inverse = std::max(std::max(a.inverse, b.inverse), c.inverse);
        const int left = std::min(std::min(a.x, b.x), c.x), right = std::max(std::max(a.x, b.x), c.x),
                  top = std::min(std::min(a.y, b.y), c.y), bottom = std::max(std::max(a.y, b.y), c.y);
        if (!(min_inverse > 0) || std::int64_t(right) - left > small_extent ||
            std::int64_t(bottom) - top > small_extent) {
            large.push_back(std::uint32_t(t));
            continue;
        }
        const auto [x0, x1] = bins(left, right, s.columns);
        const auto [y0, y1] = bins(top, bottom, s.rows);
        if (x0 > x1 || y0 > y1) continue;
        // Relative to the first corner. The slack keeps rounding from opening gaps between triangles.
        const float bx = float(b.x - a.x), by = float(b.y - a.y), cx = float(c.x - a.x),
                    cy = float(c.y - a.y), area = bx * cy - by * cx;
        const float extent = float(std::max(right - left, bottom - top)), slack = 4e-7f * extent * extent;
        if (!(std::abs(area) > slack)) continue;
        const float sign = area > 0 ? 1 : -1, share = max_depth_ratio / area;
        for (int y = y0; y <= y1; ++y) {
            const std::size_t row = std::size_t(y) * std::size_t(s.columns);
            const std::size_t end = s.first[row + std::size_t(x1) + 1];
            for (std::size_t i = s.first[row + std::size_t(x0)]; i < end; i += std::size_t(lanes)) {
                Ints x, y_at, vertex, hidden;
                Floats inverse;
                std::memcpy(&x, &s.x[i], sizeof x);
                std::memcpy(&y_at, &s.y[i], sizeof y_at);
                std::memcpy(&vertex, &s.vertex[i], sizeof vertex);
                std::memcpy(&hidden, &s.hidden[i], sizeof hidden);
                std::memcpy(&inverse, &s.inverse[i], sizeof inverse);
                const Floats px = __builtin_convertvector(x - a.x, Floats),
                             py = __builtin_convertvector(y_at - a.y, Floats);
                const Floats of_b = px * cy - py * cx, of_c = py * bx - px * by, of_a = area - of_b - of_c;
                const Ints inside =
                    (of_a * sign >= -slack) & (of_b * sign >= -slack) & (of_c * sign >= -slack);
                const Ints other =
                    (vertex != int(corners[0])) & (vertex != int(corners[1])) & (vertex != int(corners[2]));
                Floats nearest = (of_a * a.inverse + of_b * b.inverse + of_c * c.inverse) * share;
                nearest = nearest > max_inverse * max_depth_ratio ? Floats{} + max_inverse * max_depth_ratio
                                                                  : nearest;
                hidden |= inside & other & (nearest > inverse);
                std::memcpy(&s.hidden[i], &hidden, sizeof hidden);
            }
        }
    }
    return large;
}

/// The same for one clipped triangle of any size.
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
                                                const Intrinsics& photo) {
    const double max_depth_ratio = 1 - 0.3 / std::max(photo.fx, photo.fy);
    BinnedVertices binned = bin_vertices(projection);
    for (const std::uint32_t t :
         hide_by_small(projection.vertices, indices, float(max_depth_ratio), binned)) {
        const std::uint32_t* corners = &indices[3 * std::size_t(t)];
        for (const ProjectedPiece& piece : clipped(projection, corners))
            hide_by(piece, corners, max_depth_ratio, binned);
    }
    std::vector<Eigen::Vector2f> out(projection.vertices.size(), Eigen::Vector2f(-1, -1));
    // Fixed-point positions are finer than single-precision texture coordinates.
    const double pixel = double(1 << mask_level) / (1 << position_bits), x = pixel / photo.width,
                 y = pixel / photo.height;
    for (std::size_t i = 0; i < binned.first.back(); ++i)
        if (const Eigen::Vector2d at(binned.x[i] * x, binned.y[i] * y);
            !binned.hidden[i] && at.maxCoeff() < 1)
            out[std::size_t(binned.vertex[i])] = at.cast<float>();
    return out;
}

}  // namespace vantage
