#include "pipeline/stages/visibility.h"

#include <algorithm>

namespace vantage {

void settle_visibility(const RayScene& rays, std::span<const Eigen::Vector3f> positions, const Intrinsics& k,
                       const Pose& pose, std::span<Eigen::Vector2f> coordinates) {
    const Eigen::Vector3d eye = pose.center();
    const double almost_there = 1 - 0.3 / std::max(k.fx, k.fy);
    for (std::size_t v = 0; v < coordinates.size(); ++v) {
        if (coordinates[v].x() != unsettled_coordinate) continue;
        coordinates[v] = Eigen::Vector2f(-1, -1);
        const Eigen::Vector3d point = positions[v].cast<double>();
        const auto seen = project(k, pose, point);
        if (!seen || rays.occluded(eye, point - eye, 0, almost_there)) continue;
        const Eigen::Vector2d uv = seen->pixel.cwiseQuotient(Eigen::Vector2d(k.width, k.height));
        // The pass found it inside by single precision.
        coordinates[v] = uv.cwiseMax(0).cwiseMin(1).cast<float>();
    }
}

}  // namespace vantage
