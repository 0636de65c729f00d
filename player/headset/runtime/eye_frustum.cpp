#include "player/headset/runtime/eye_frustum.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace vantage {

std::optional<EyeFrustum> eye_frustum(const RoomPose& pose, double left, double right, double up,
                                      double down) {
    constexpr double widest = 89.9 * std::numbers::pi / 180, least = 1e-3;  // radians
    if (left > right) std::swap(left, right);
    if (down > up) std::swap(down, up);
    const bool in_range = left > -widest && right < widest && down > -widest && up < widest;
    if (!is_valid(pose) || !in_range || !(right - left > least) || !(up - down > least)) return {};
    return EyeFrustum{pose, std::tan(left), std::tan(right), std::tan(up), std::tan(down)};
}

View view_of_eye(const Stance& stance, const EyeFrustum& eye, FrameSize size) {
    View out;
    Intrinsics& k = out.intrinsics;
    k.width = size.width, k.height = size.height;
    k.fx = size.width / (eye.right - eye.left);
    k.fy = size.height / (eye.up - eye.down);
    k.cx = -eye.left * k.fx;
    k.cy = eye.up * k.fy;
    const Eigen::Vector3d camera_axes(1, -1, -1);  // y down, z forward
    Pose& pose = out.cam_from_origin;
    pose.R = camera_axes.asDiagonal() * eye.pose.turn.toRotationMatrix().transpose() * stance.R.transpose();
    pose.t = -pose.R * in_scene(stance, eye.pose.at);
    return out;
}

}  // namespace vantage
