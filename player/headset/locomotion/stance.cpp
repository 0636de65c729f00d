#include "player/headset/locomotion/stance.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

const Eigen::Vector3d room_up = Eigen::Vector3d::UnitY();

Eigen::Matrix3d about_up(double angle) { return Eigen::AngleAxisd(angle, room_up).toRotationMatrix(); }

/// Angle about the room's up axis from forward (-z) to a direction; 0 for a vertical direction.
double heading(const Eigen::Vector3d& direction) {
    const double x = direction.x(), z = direction.z();
    return std::hypot(x, z) > 1e-6 * direction.norm() ? std::atan2(-x, -z) : 0;
}

/// Axes of a level room in a scene with this up direction; z is as close to -`ahead` as possible.
Eigen::Matrix3d level_axes(const Eigen::Vector3d& ahead, const Eigen::Vector3d& up) {
    Eigen::Vector3d z = -(ahead - up * up.dot(ahead));
    if (!(z.norm() > 1e-6 * ahead.norm())) z = up.unitOrthogonal();
    z.normalize();
    Eigen::Matrix3d R;
    R << up.cross(z), up, z;
    return R;
}

/// Translates a stance so that the point `room` of the room is at the point `scene` of the scene.
Stance through(Stance s, const Eigen::Vector3d& room, const Eigen::Vector3d& scene) {
    s.at = scene - s.scale * (s.R * room);
    return s;
}

}  // namespace

Eigen::Vector3d in_scene(const Stance& s, const Eigen::Vector3d& room) {
    return s.at + s.scale * (s.R * room);
}

Eigen::Vector3d in_room(const Stance& s, const Eigen::Vector3d& scene) {
    return s.R.transpose() * (scene - s.at) / s.scale;
}

Stance standing(const RoomPose& head, const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                const Eigen::Vector3d& up, double scale) {
    Stance s;
    s.R = level_axes(target - eye, up) * about_up(-heading(head.ahead()));
    s.scale = scale;
    return through(s, head.at, eye);
}

Stance rescaled(Stance s, const Eigen::Vector3d& about, double scale) {
    s.at = about + (s.at - about) * (scale / s.scale);
    s.scale = scale;
    return s;
}

Stance turned(const Stance& stance, const RoomPose& head, double angle) {
    Stance s = stance;
    s.R = stance.R * about_up(angle);
    return through(s, head.at, in_scene(stance, head.at));
}

Stance moved(Stance stance, const Eigen::Vector3d& by) {
    stance.at += by;
    return stance;
}

Stance stood_on(Stance stance, const RoomPose& head, const Eigen::Vector3d& point) {
    return through(stance, {head.at.x(), 0, head.at.z()}, point);
}

Stance held(const Hold& hold, std::span<const Eigen::Vector3d> hands, double smallest, double largest) {
    const auto& [before, closed, count] = hold;
    if (count < 2) return through(before, hands[0], in_scene(before, closed[0]));
    const Eigen::Vector3d span = closed[1] - closed[0], now = hands[1] - hands[0];
    constexpr double least_span = 0.02;  // meters: below, the direction between hands is undefined
    Stance s = before;
    if (span.norm() > least_span && now.norm() > least_span) {
        s.scale = std::clamp(before.scale * span.norm() / now.norm(), smallest, largest);
        // Hands that are vertically aligned do not turn the scene.
        const auto level = [](const Eigen::Vector3d& v) { return std::hypot(v.x(), v.z()); };
        if (level(span) > least_span && level(now) > least_span)
            s.R = before.R * about_up(heading(span) - heading(now));
    }
    return through(s, (hands[0] + hands[1]) / 2, in_scene(before, (closed[0] + closed[1]) / 2));
}

}  // namespace vantage
