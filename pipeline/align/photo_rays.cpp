#include "pipeline/align/photo_rays.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "scene/camera/lens_inverse.h"

namespace vantage {

double longer_side(const Camera& camera) {
    return double(std::max(camera.intrinsics.width, camera.intrinsics.height));
}

std::optional<Eigen::Vector2d> PhotoRays::pinhole(std::uint32_t photo, const Eigen::Vector2d& pixel) {
    const Camera& c = cameras_[photo];
    const auto [range, is_new] = ranges_.try_emplace(photo, 0);
    if (is_new) range->second = lens_range(c.lens);
    const Intrinsics& k = c.intrinsics;
    return undistort(c.lens, range->second, {(pixel.x() - k.cx) / k.fx, (pixel.y() - k.cy) / k.fy});
}

std::optional<Eigen::Vector2d> imaged(const Camera& camera, const Eigen::Vector3d& point) {
    const Eigen::Vector3d p = camera.cam_from_world.R * point + camera.cam_from_world.t;
    if (!(p.z() > 0)) return {};
    const Intrinsics& k = camera.intrinsics;
    const Eigen::Vector2d d = distort(camera.lens, p.hnormalized());
    const Eigen::Vector2d pixel(k.fx * d.x() + k.cx, k.fy * d.y() + k.cy);
    return pixel.allFinite() ? std::optional(pixel) : std::nullopt;
}

}  // namespace vantage
