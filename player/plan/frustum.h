#pragma once
#include <Eigen/Core>
#include <array>

#include "player/view/view.h"

namespace vantage {

/// Inside: normal.dot(p) + offset >= 0, relative to the origin.
struct HalfSpace {
    Eigen::Vector3d normal;
    double offset;
};

/// What a view can show: four sides, and what is in front of the camera.
using Frustum = std::array<HalfSpace, 5>;
Frustum frustum(const View& view);

/// Where a box is; never `outside` if a point of it is inside, never `inside` if one is outside.
enum class Side { outside, across, inside };
Side side_of(const Frustum& planes, const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// Whether a sphere reaches into all planes; true if any of it is inside.
bool reaches(const Frustum& planes, const Eigen::Vector3d& center, double radius);

}  // namespace vantage
