#pragma once
#include <Eigen/Core>
#include <span>

#include "scene/package/package_format.h"

namespace vantage {

/// The angle in radians between a viewing direction and the closest viewing direction of a photo with pixels;
/// 0 if no photo has pixels.
double angle_from_photos(std::span<const package::PhotoRecord> photos, const Eigen::Vector3d& direction);

}  // namespace vantage
