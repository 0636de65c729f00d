#pragma once
#include <Eigen/Core>
#include <vector>

#include "scene/camera/camera.h"

namespace vantage {

/// The convex hull of the visible vertices in a photo [P, 2.3.3]: the unit direction through its centroid and
/// its area as a fraction of the photo. If no vertex is visible, the direction is the optical axis and the
/// area is 0. For collinear points, the direction is that of their mean and the area is 0.
struct FootprintHull {
    Eigen::Vector3d direction;
    double area = 0;
};
/// `coordinates`: as returned by vertex_coordinates().
FootprintHull footprint_hull(const std::vector<Eigen::Vector2f>& coordinates, const Intrinsics& intrinsics,
                             const Pose& cam_from_origin);

}  // namespace vantage
