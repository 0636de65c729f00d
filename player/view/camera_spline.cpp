#include "player/view/camera_spline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace vantage {
namespace {

/// The components of a state: the target, the logarithm of the distance, the logarithm of half the picture's
/// height at distance 1, and the camera's rotation as a quaternion.
struct Part {
    int first, count;
};
constexpr Part parts[] = {{0, 3}, {3, 1}, {4, 1}, {5, 4}};
constexpr int target_at = 0, distance_at = 3, fov_at = 4, rotation_at = 5;

double distance_of(const Navigation& n) { return std::max((n.target - n.eye).norm(), 1e-9); }

bool is_level(const Navigation& n) {
    constexpr double steepest = 0.9994;  // 2 degrees from the poles
    return std::abs(n.R.row(0).dot(n.up)) < 1e-6 && std::abs(n.R.row(2).dot(n.up)) < steepest;
}

/// The rotation of a camera with the same viewing direction and `up` at the top of the picture.
Eigen::Matrix3d leveled(const Eigen::Matrix3d& R, const Eigen::Vector3d& up) {
    const Eigen::Vector3d ahead = R.row(2);
    const Eigen::Vector3d right = ahead.cross(up);
    if (right.norm() < 0.01 * up.norm()) return R;
    Eigen::Matrix3d out;
    out.row(0) = right.normalized();
    out.row(1) = ahead.cross(right.normalized());
    out.row(2) = ahead;
    return out;
}

/// The velocity of each component at the middle of three keys: that of the parabola through the keys, but at
/// most three times the lower of the speeds on the two sides, to avoid overshooting. It is 0 if one side is
/// at rest.
Eigen::VectorXd middle_speed(const Eigen::VectorXd& before, double seconds_before,
                             const Eigen::VectorXd& after, double seconds_after) {
    if (!(seconds_before > 0) || !(seconds_after > 0)) return Eigen::VectorXd::Zero(before.size());
    const Eigen::VectorXd a = before / seconds_before, b = after / seconds_after;
    Eigen::VectorXd speed = (seconds_after * a + seconds_before * b) / (seconds_before + seconds_after);
    const double most = 3 * std::min(a.norm(), b.norm());
    if (speed.norm() > most) speed *= most / speed.norm();
    return speed;
}

}  // namespace

CameraSpline::CameraSpline(std::span<const KeyView> keys)
    : up_(keys.front().camera.up),
      level_(std::ranges::all_of(keys, [](const KeyView& k) { return is_level(k.camera); })) {
    for (const KeyView& key : keys) {
        const Navigation& n = key.camera;
        Place p;
        p.segment<3>(target_at) = n.eye + distance_of(n) * n.R.row(2).transpose();
        p[distance_at] = std::log(distance_of(n));
        p[fov_at] = std::log(std::tan(n.fov * std::numbers::pi / 360));
        p.segment<4>(rotation_at) = Eigen::Quaterniond(n.R).coeffs();
        if (!knots_.empty() && knots_.back().place.segment<4>(rotation_at).dot(p.segment<4>(rotation_at)) < 0)
            p.segment<4>(rotation_at) *= -1;  // the same rotation, on the shorter path
        knots_.push_back({key.seconds, p, Place::Zero()});
    }
    for (std::size_t i = 1; i + 1 < knots_.size(); ++i)
        for (const auto& [first, count] : parts)
            knots_[i].speed.segment(first, count) =
                middle_speed((knots_[i].place - knots_[i - 1].place).segment(first, count),
                             knots_[i].seconds - knots_[i - 1].seconds,
                             (knots_[i + 1].place - knots_[i].place).segment(first, count),
                             knots_[i + 1].seconds - knots_[i].seconds);
}

Navigation CameraSpline::at(double seconds) const {
    const auto after = std::ranges::upper_bound(knots_, seconds, {}, &Knot::seconds);
    if (after == knots_.begin()) return camera_at(knots_.front().place);
    const Knot& a = *(after - 1);
    if (after == knots_.end()) return camera_at(a.place);
    const Knot& b = *after;
    if (a.place == b.place) return camera_at(a.place);  // without the rounding errors of the curve
    const double length = b.seconds - a.seconds, t = (seconds - a.seconds) / length, u = 1 - t;
    // Cubic Hermite curve.
    return camera_at(u * u * (1 + 2 * t) * a.place + t * t * (3 - 2 * t) * b.place +
                     length * t * u * (u * a.speed - t * b.speed));
}

Navigation CameraSpline::camera_at(const Place& p) const {
    Navigation out;
    out.up = up_;
    out.target = p.segment<3>(target_at);
    out.fov = 2 * std::atan(std::exp(p[fov_at])) * 180 / std::numbers::pi;
    const Eigen::Vector4d rotation = p.segment<4>(rotation_at);
    out.R = Eigen::Quaterniond(rotation.norm() > 1e-6 ? rotation.normalized() : Eigen::Vector4d::UnitW())
                .toRotationMatrix();
    if (level_) out.R = leveled(out.R, up_);
    out.eye = out.target - std::exp(p[distance_at]) * out.R.row(2).transpose();
    return out;
}

}  // namespace vantage
