#pragma once
#include <Eigen/Core>
#include <optional>

#include "scene/camera/lens.h"

namespace vantage {

/// The inverse of distort(): the normalized pinhole coordinates that the lens images at `xy`, to 1e-12 where
/// the lens is not close to its fold. Empty if there are none within lens_range(), which the caller gives,
/// because it is slow to find.
std::optional<Eigen::Vector2d> undistort(const Lens& lens, double range, const Eigen::Vector2d& xy);

}  // namespace vantage
