#pragma once
#include <Eigen/Core>
#include <optional>

#include "scene/camera/lens.h"

namespace vantage {

/// The inverse of distort(): the normalized pinhole coordinates that the lens images at `xy`, accurate to
/// 1e-12 except near the radius at which the lens folds back. Empty if there are none within lens_range().
/// The caller passes this range as `range`, because computing it is slow.
std::optional<Eigen::Vector2d> undistort(const Lens& lens, double range, const Eigen::Vector2d& xy);

}  // namespace vantage
