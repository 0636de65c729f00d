#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>

#include "agreement/surface_discs.h"
#include "pipeline/surroundings/coarse_view.h"

namespace vantage {

/// The direction that the photos' rows agree to call down: perpendicular to all of them, as nobody holds a
/// camera askew on purpose. If all rows are parallel, the mean of the columns. Unit length. Off by several
/// degrees where the cameras look much the same way and were not held quite level.
Eigen::Vector3d down_direction(std::span<const Pose> poses);
Eigen::Vector3d down_direction(std::span<const CoarseView> views);

/// The direction within 15 degrees of `held` that a mesh's walls are parallel to and its floors face. Unit
/// length; nothing if less than a fifth of the discs are on walls or floors.
std::optional<Eigen::Vector3d> down_direction(std::span<const SurfaceDisc> discs,
                                              const Eigen::Vector3d& held);

}  // namespace vantage
