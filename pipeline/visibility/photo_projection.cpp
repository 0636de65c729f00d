#include "pipeline/visibility/photo_projection.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

std::int64_t nearest(double v) { return std::int64_t(v < 0 ? v - 0.5 : v + 0.5); }

struct Point {
    double x, y, inverse;
};

Point project(const Eigen::Vector3d& p, const Intrinsics& k) {
    constexpr double one = 1 << position_bits;
    const double inverse = 1 / p.z();
    return {(k.fx * p.x() * inverse + k.cx) * one, (k.fy * p.y() * inverse + k.cy) * one, inverse};
}

}  // namespace

PhotoProjection project_model(std::span<const Eigen::Vector3f> positions, const Intrinsics& map,
                              const Pose& pose, double near) {
    constexpr double max_position = 1 << 30;
    PhotoProjection out{positions, map, pose, float(near), {}};
    out.vertices.reserve(positions.size());
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        const Eigen::Vector3d p = out.in_camera(v);
        const Point at = project(p, map);
        if (p.z() > 0 && p.z() >= out.near && std::abs(at.x) < max_position && std::abs(at.y) < max_position)
            out.vertices.push_back(
                {std::int32_t(nearest(at.x)), std::int32_t(nearest(at.y)), float(at.inverse)});
        else
            out.vertices.push_back({0, 0, 0});
    }
    return out;
}

double ProjectedPiece::clamped(double inverse_depth) const {
    const auto [low, high] = std::minmax({inverse[0], inverse[1], inverse[2]});
    return std::clamp(inverse_depth, low, high);
}

ProjectedPieces clipped(const PhotoProjection& projection, const std::uint32_t* corners) {
    const double near = projection.near;
    ProjectedPieces out;
    if (!(near > 0)) return out;  // nothing lies in front of the camera
    std::array<Eigen::Vector3d, 4> kept;
    std::size_t n = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d a = projection.in_camera(corners[i]),
                              b = projection.in_camera(corners[(i + 1) % 3]);
        if (a.z() >= near) kept[n++] = a;
        if ((a.z() >= near) == (b.z() >= near)) continue;
        kept[n] = a + (near - a.z()) / (b.z() - a.z()) * (b - a);
        kept[n++].z() = near;
    }
    for (std::size_t i = 2; i < n; ++i) {
        ProjectedPiece& piece = out.piece[std::size_t(out.count++)];
        const std::size_t from[3] = {0, i - 1, i};
        for (std::size_t c = 0; c < 3; ++c) {
            const Point at = project(kept[from[c]], projection.intrinsics);
            // This is far outside any photo, but fits in 64 bits.
            constexpr double farthest = 1e18;
            piece.x[c] = nearest(std::clamp(at.x, -farthest, farthest));
            piece.y[c] = nearest(std::clamp(at.y, -farthest, farthest));
            piece.inverse[c] = at.inverse;
        }
    }
    return out;
}

}  // namespace vantage
