#include "scene/camera/camera.h"

#include <Eigen/LU>
#include <cmath>
#include <string>

#include "base/text/error.h"
#include "base/values/nearest_rotation.h"
#include "base/values/tiling.h"

namespace vantage {

Eigen::Vector3d Pose::center() const { return -R.transpose() * t; }
Eigen::Vector3d Pose::direction() const { return R.row(2).transpose(); }
Pose Pose::relative_to(const Eigen::Vector3d& origin) const { return {R, t + R * origin}; }

Intrinsics Intrinsics::scaled(int new_width, int new_height) const {
    const double sx = double(new_width) / width, sy = double(new_height) / height;
    return {new_width, new_height, fx * sx, fy * sy, cx * sx, cy * sy};
}

Intrinsics Intrinsics::at_level(int level) const {
    const Level size = level_size(width, height, level);
    const double s = 1.0 / (1 << level);
    return {size.width, size.height, fx * s, fy * s, cx * s, cy * s};
}

std::optional<Projection> project(const Intrinsics& k, const Pose& pose, const Eigen::Vector3d& point) {
    const Eigen::Vector3d p = pose.R * point + pose.t;
    if (!(p.z() > 0)) return std::nullopt;
    const Eigen::Vector2d pixel(k.fx * p.x() / p.z() + k.cx, k.fy * p.y() / p.z() + k.cy);
    if (!pixel.allFinite()) return std::nullopt;
    return Projection{pixel, p.z()};
}

Eigen::Matrix4d clip_from_cam(const Intrinsics& k, double near, double far) {
    // x_ndc = 2 u / w - 1 with u = fx x / z + cx; v = 0 is the first row in memory, so y is not flipped.
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = 2 * k.fx / k.width;
    m(0, 2) = 2 * k.cx / k.width - 1;
    m(1, 1) = 2 * k.fy / k.height;
    m(1, 2) = 2 * k.cy / k.height - 1;
    m(2, 2) = -near / (far - near);
    m(2, 3) = far * near / (far - near);
    m(3, 2) = 1;
    return m;
}

Eigen::Vector2d clip_range(double nearest, double farthest, double reach) {
    if (!(farthest > 0)) return {0, 0};
    return {std::max(nearest * 0.999, std::min(farthest, reach) * 1e-7), farthest * 1.001};
}

void validate(Camera& camera, const std::string& who) {
    const auto fail = [&](const std::string& what) { throw Error(Exit::input, who + ": " + what); };
    const Intrinsics& k = camera.intrinsics;
    if (k.width <= 0 || k.height <= 0) fail("the photo size is not positive");
    if (!(k.fx > 0 && k.fy > 0 && std::isfinite(k.fx) && std::isfinite(k.fy)))
        fail("focal length must be positive and finite");
    if (!std::isfinite(k.cx) || !std::isfinite(k.cy)) fail("principal point is not finite");
    for (const double p : camera.lens.p)
        if (!std::isfinite(p)) fail("a lens parameter is not finite");
    Pose& pose = camera.cam_from_world;
    if (!pose.R.allFinite() || !pose.t.allFinite()) fail("pose is not finite");
    const Eigen::Matrix3d nearest = nearest_orthogonal(pose.R);
    if ((nearest - pose.R).norm() > 1e-3 || nearest.determinant() < 0)
        fail("rotation is not a right-handed orthonormal matrix");
    pose.R = nearest;
}

}  // namespace vantage
