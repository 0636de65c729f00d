#pragma once
#include <Eigen/Core>
#include <vector>

#include "scene/camera.h"

namespace vantage {

/// The direction through the centroid of the convex hull of what a photo sees, and the hull's share of the
/// photo
/// ([P] 2.3.3). No visible point: the optical axis and 0; collinear points: through their mean, and 0.
struct SeenHull {
    Eigen::Vector3d direction;
    double area = 0;
};
SeenHull seen_hull(const std::vector<Eigen::Vector2f>& coordinates, const Intrinsics& intrinsics,
                   const Pose& cam_from_origin);

}  // namespace vantage
