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

/// Positions in triangles of at most this extent are exact in single precision.
constexpr int small_extent = 62 << position_bits;

/// The vertices in a map's frame, by square bins, row by row; so those in a range of a row's bins stand
/// together.
struct Sights {
    static constexpr int bin_bits = position_bits + 2;  ///< four pixels
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> first;  ///< vertex of a bin, and of the one after the last
    // Each as long as there are vertices, and `lanes` more that nothing hides.
    std::vector<std::int32_t> x, y, vertex, hidden;
    std::vector<float> inverse;
};

Sights bin(const PhotoProjection& p) {
    constexpr int pixels = 1 << (Sights::bin_bits - position_bits);
    Sights s;
    s.columns = (p.intrinsics.width + pixels - 1) / pixels;
    s.rows = (p.intrinsics.height + pixels - 1) / pixels;
    const auto in_frame = [&](const ProjectedVertex& v) {
        return v.inverse > 0 && v.x >= 0 && v.y >= 0 && v.x >> Sights::bin_bits < s.columns &&
               v.y >> Sights::bin_bits < s.rows;
    };
    const auto bin_of = [&](const ProjectedVertex& v) {
        return std::size_t(v.y >> Sights::bin_bits) * std::size_t(s.columns) +
               std::size_t(v.x >> Sights::bin_bits);
    };
    // Counted two bins on, a bin's first is where the next of its vertices goes, one bin on.
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
    return {int(std::clamp<Int>(low >> Sights::bin_bits, 0, count)),
            int(std::clamp<Int>(high >> Sights::bin_bits, -1, count - 1))};
}

/// Marks the vertices that small triangles hide: those whose lines of sight meet a triangle before `there` of
/// the way. Returns the other triangles.
VANTAGE_SIMD std::vector<std::uint32_t> hide_by_small(std::span<const ProjectedVertex> vertices,
                                                      std::span<const std::uint32_t> indices, float there,
                                                      Sights& s) {
    std::vector<std::uint32_t> others;
    for (std::size_t t = 0; 3 * t < indices.size(); ++t) {
        const std::uint32_t* corners = &indices[3 * t];
        const ProjectedVertex a = vertices[corners[0]], b = vertices[corners[1]], c = vertices[corners[2]];
        const float least = std::min(std::min(a.inverse, b.inverse), c.inverse),
                    most = std::max(std::max(a.inverse, b.inverse), c.inverse);
        const int left = std::min(std::min(a.x, b.x), c.x), right = std::max(std::max(a.x, b.x), c.x),
                  top = std::min(std::min(a.y, b.y), c.y), bottom = std::max(std::max(a.y, b.y), c.y);
        if (!(least > 0) || std::int64_t(right) - left > small_extent ||
            std::int64_t(bottom) - top > small_extent) {
            others.push_back(std::uint32_t(t));
            continue;
        }
        const auto [x0, x1] = bins(left, right, s.columns);
        const auto [y0, y1] = bins(top, bottom, s.rows);
        if (x0 > x1 || y0 > y1) continue;
        // Relative to the first corner; rounding must not open a gap between two triangles.
        const float bx = float(b.x - a.x), by = float(b.y - a.y), cx = float(c.x - a.x),
                    cy = float(c.y - a.y), area = bx * cy - by * cx;
        const float extent = float(std::max(right - left, bottom - top)), slack = 4e-7f * extent * extent;
        if (!(std::abs(area) > slack)) continue;
        const float sign = area > 0 ? 1 : -1, share = there / area;
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
                nearest = nearest > most * there ? Floats{} + most * there : nearest;
                hidden |= inside & other & (nearest > inverse);
                std::memcpy(&s.hidden[i], &hidden, sizeof hidden);
            }
        }
    }
    return others;
}

/// The same for a triangle, or a piece of one, of any size.
void hide_by(const ProjectedPiece& p, const std::uint32_t* corners, double there, Sights& s) {
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
            if (nearest * there > double(s.inverse[i])) s.hidden[i] = -1;
        }
    }
}

}  // namespace

std::vector<Eigen::Vector2f> vertex_coordinates(const PhotoProjection& projection,
                                                std::span<const std::uint32_t> indices,
                                                const Intrinsics& photo) {
    const double there = 1 - 0.3 / std::max(photo.fx, photo.fy);
    Sights sights = bin(projection);
    for (const std::uint32_t t : hide_by_small(projection.vertices, indices, float(there), sights)) {
        const std::uint32_t* corners = &indices[3 * std::size_t(t)];
        for (const ProjectedPiece& piece : clipped(projection, corners))
            hide_by(piece, corners, there, sights);
    }
    std::vector<Eigen::Vector2f> out(projection.vertices.size(), Eigen::Vector2f(-1, -1));
    // Positions are finer than a texture coordinate's last digit.
    const double pixel = double(1 << mask_level) / (1 << position_bits), x = pixel / photo.width,
                 y = pixel / photo.height;
    for (std::size_t i = 0; i < sights.first.back(); ++i)
        if (const Eigen::Vector2d at(sights.x[i] * x, sights.y[i] * y);
            !sights.hidden[i] && at.maxCoeff() < 1)
            out[std::size_t(sights.vertex[i])] = at.cast<float>();
    return out;
}

}  // namespace vantage
