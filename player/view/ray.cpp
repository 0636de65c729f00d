#include "player/view/ray.h"

namespace vantage {

Ray ray_through(const View& view, const Eigen::Vector2d& pixel) {
    const Intrinsics& k = view.intrinsics;
    const Eigen::Vector3d ahead((pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy, 1);
    return {view.cam_from_origin.center(), view.cam_from_origin.R.transpose() * ahead.normalized()};
}

}  // namespace vantage
