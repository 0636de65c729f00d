#pragma once
#include <Eigen/Core>
#include <optional>

#include "scene/camera/lens.h"

namespace vantage {

/// The inverse of distort(): the normalized pinhole coordinates that the lens images at `xy`, accurate to
/// 1e-12 away from the lens's fold. Empty if there are none within lens_range(), which the caller passes
/// because it is slow to compute.
std::optional<Eigen::Vector2d> undistort(const Lens& lens, double range, const Eigen::Vector2d& xy);

}  // namespace vantage
