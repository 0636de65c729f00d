#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>

#include "scene/agreement/surface_discs.h"
#include "scene/camera/camera.h"

namespace vantage {

/// The direction that is up, of length 1: that of the cameras, corrected by the surface where it has walls
/// and floors; the nearest coordinate axis, if that is within the error. Without poses +z.
Eigen::Vector3d up_direction(std::span<const Pose> poses, std::span<const SurfaceDisc> discs);

/// A direction of length 1, and its standard error in radians.
struct UpEstimate {
    Eigen::Vector3d up;
    double error;
};

/// From how cameras were held: perpendicular to their rows, since photographers tilt cameras up and down and
/// seldom roll them. A camera on its side counts by its columns. What parallel rows leave open, the mean of
/// the columns decides. Off by some degrees where photographers rolled all cameras alike.
UpEstimate up_of_cameras(std::span<const Pose> poses);

/// The direction within 15 degrees of `held` that the surface's walls are parallel to and its floors face;
/// nothing if less than a fifth of the discs are on walls or floors.
std::optional<Eigen::Vector3d> up_of_surface(std::span<const SurfaceDisc> discs, const Eigen::Vector3d& held);

}  // namespace vantage
