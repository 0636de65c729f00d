#include "player/interface/overlays/photo_frustum.h"

namespace vantage {

PhotoFrustum photo_frustum(const PlanScene& scene, std::uint32_t photo, double depth) {
    const Intrinsics& k = scene.intrinsics[photo];
    const Pose& pose = scene.poses[photo];
    PhotoFrustum out{pose.center(), {}};
    for (std::size_t c = 0; c < 4; ++c) {
        const double u = c == 1 || c == 2 ? k.width : 0, v = c >= 2 ? k.height : 0;
        const Eigen::Vector3d ahead((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1);
        out.corner[c] = out.center + pose.R.transpose() * (ahead * depth);
    }
    return out;
}

PhotoFrustum photo_frustum(const PlanScene& scene, std::uint32_t photo) {
    return photo_frustum(scene, photo, 0.06 * scene.size);
}

}  // namespace vantage
