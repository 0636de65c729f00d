#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>

#include "scene/agreement/surface_discs.h"
#include "scene/camera/camera.h"

namespace vantage {

/// The unit up direction. It is estimated from the cameras, corrected using the surface if the surface has
/// walls and floors, and replaced by the nearest coordinate axis if that axis is within the error. Without
/// poses, it is +z.
Eigen::Vector3d up_direction(std::span<const Pose> poses, std::span<const SurfaceDisc> discs);

/// A unit direction and its standard error in radians.
struct UpEstimate {
    Eigen::Vector3d up;
    double error;
};

/// The up direction estimated from the orientation of the cameras: perpendicular to their rows, since
/// photographers tilt cameras up and down but seldom roll them. For a camera on its side, its columns are
/// used instead. If the rows are parallel, the mean of the columns resolves the ambiguity. The estimate is
/// off by a few degrees if all cameras were rolled in the same way.
UpEstimate up_of_cameras(std::span<const Pose> poses);

/// The direction within 15 degrees of `held` that is parallel to the surface's walls and perpendicular to its
/// floors; empty if fewer than a fifth of the discs are on walls or floors.
std::optional<Eigen::Vector3d> up_of_surface(std::span<const SurfaceDisc> discs, const Eigen::Vector3d& held);

}  // namespace vantage
