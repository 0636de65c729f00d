#include "pipeline/visibility/photo_geometry.h"

#include <algorithm>
#include <limits>

#include "base/values/tiling.h"

namespace vantage {

Eigen::Vector2d depth_range(std::span<const Eigen::Vector3f> positions, const Pose& pose, double reach) {
    const Eigen::Vector3d axis = pose.R.row(2);
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const Eigen::Vector3f& p : positions) {
        const double z = axis.dot(p.cast<double>()) + pose.t.z();
        // A vertex behind the camera may belong to a triangle that crosses the camera's plane.
        nearest = std::min(nearest, std::max(z, 0.0));
        farthest = std::max(farthest, z);
    }
    return clip_range(nearest, farthest, reach);
}

Intrinsics map_intrinsics(const Intrinsics& k) { return k.at_level(weight_map_level); }

PhotoGeometry empty_geometry(const Intrinsics& k) {
    const Level half = level_size(k.width, k.height, weight_map_level);
    const std::size_t pixels = std::size_t(half.width) * std::size_t(half.height);
    return {half.width, half.height, std::vector<float>(pixels, std::numeric_limits<float>::infinity()),
            std::vector<std::uint8_t>(pixels, 0), std::vector<std::uint32_t>(pixels, ~0u)};
}

}  // namespace vantage
