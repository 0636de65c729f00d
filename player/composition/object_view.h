#pragma once
#include "player/plan/section_plane.h"
#include "player/view/view.h"
#include "scene/story/placement.h"

namespace vantage {

/// A view of the scene, relative to `scene_origin`, as a view of one of its objects, relative to
/// `object_origin`, which is the middle of its bounds. Both show the object at the same pixels; depths are
/// those of the scene divided by the scale. The exposure is the mean one: that of the view is of another
/// object's photos.
View view_of_object(const View& view, const Eigen::Vector3d& scene_origin,
                    const Eigen::Vector3d& object_origin, const Placement& placement);

/// A plane of the scene as one of the object.
SectionPlane plane_of_object(const SectionPlane& plane, const Eigen::Vector3d& scene_origin,
                             const Eigen::Vector3d& object_origin, const Placement& placement);

}  // namespace vantage
