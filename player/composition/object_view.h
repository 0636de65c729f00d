#pragma once
#include "player/plan/section_plane.h"
#include "player/view/view.h"
#include "scene/story/placement.h"

namespace vantage {

/// Converts a view of the scene, relative to `scene_origin`, to a view of one of its objects, relative to
/// `object_origin`, the center of its bounds. Both views show the object at the same pixels; depths are those
/// of the scene divided by the scale. The exposure is set to the mean, because the exposure of `view` refers
/// to another object's photos.
View view_of_object(const View& view, const Eigen::Vector3d& scene_origin,
                    const Eigen::Vector3d& object_origin, const Placement& placement);

/// Converts a plane of the scene to the object's coordinates.
SectionPlane plane_of_object(const SectionPlane& plane, const Eigen::Vector3d& scene_origin,
                             const Eigen::Vector3d& object_origin, const Placement& placement);

}  // namespace vantage
