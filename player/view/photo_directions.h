#pragma once
#include <Eigen/Core>
#include <span>

#include "player/view/turntable.h"
#include "scene/package/package_format.h"

namespace vantage {

/// Angle in radians from the viewing directions of the photos up to which the view orbits freely. Beyond it,
/// little of the model was photographed.
inline constexpr double free_angle = 0.35;

/// The angle in radians between a viewing direction and the closest viewing direction of a photo with pixels;
/// 0 if no photo has pixels.
double angle_from_photos(std::span<const package::PhotoRecord> photos, const Eigen::Vector3d& direction);

/// The arc in which a camera can orbit its target without leaving the photos' directions by more than
/// `free_angle` or, if it has left them already, by more than now.
Arc arc_near_photos(std::span<const package::PhotoRecord> photos, const Navigation& camera);

}  // namespace vantage
