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

/// The visible volume of a view: four sides, and the plane in front of the camera.
using Frustum = std::array<HalfSpace, 5>;
Frustum frustum(const View& view);

/// Position of a box relative to a frustum; never `outside` if any point of the box is inside, and never
/// `inside` if any point is outside.
enum class Side { outside, across, inside };
Side side_of(const Frustum& planes, const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// Whether a sphere intersects all half-spaces; true if any part of the sphere is inside.
bool reaches(const Frustum& planes, const Eigen::Vector3d& center, double radius);

}  // namespace vantage
