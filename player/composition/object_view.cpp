#include "player/composition/object_view.h"

namespace vantage {

View view_of_object(const View& view, const Eigen::Vector3d& scene_origin,
                    const Eigen::Vector3d& object_origin, const Placement& placement) {
    View out = view;
    out.exposure = {};
    const Pose& camera = view.cam_from_origin;
    out.cam_from_origin.R = camera.R * rotation_of(placement);
    const Eigen::Vector3d middle = object_origin + placement.move - scene_origin;
    out.cam_from_origin.t = (camera.R * middle + camera.t) / placement.scale;
    out.orthographic_depth = view.orthographic_depth / placement.scale;
    return out;
}

SectionPlane plane_of_object(const SectionPlane& plane, const Eigen::Vector3d& scene_origin,
                             const Eigen::Vector3d& object_origin, const Placement& placement) {
    const Eigen::Vector3d middle = object_origin + placement.move - scene_origin;
    return plane_in(plane, rotation_of(placement), middle, placement.scale);
}

}  // namespace vantage
