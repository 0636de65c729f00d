#include "player/headset/locomotion/teleport_arc.h"

#include <cmath>

namespace vantage {
namespace {

constexpr double speed = 7.5, gravity = 9.81, step = 1.0 / 25, longest = 3;  // meters and seconds
constexpr double steepest = 0.7071;                                          // cosine of 45 degrees
constexpr double deepest = 3, before_wall = 0.5, wall_height = 10;           // meters

bool can_stand_on(const SurfacePoint& s, const Eigen::Vector3d& up) { return s.normal.dot(up) >= steepest; }

/// The floor in front of a wall or below an overhang.
std::optional<Eigen::Vector3d> foot_of(const SurfacePoint& wall, const Stance& stance,
                                       const SurfaceBetween& surface) {
    const Eigen::Vector3d up = stance.up();
    const Eigen::Vector3d level = wall.normal - up * up.dot(wall.normal);
    // The normal of a ceiling is vertical, so the search for the floor starts just below the ceiling.
    const Eigen::Vector3d away = level.norm() > 0.1 ? level.normalized() * before_wall : wall.normal * 0.01;
    const Eigen::Vector3d from = wall.at + away * stance.scale;
    const auto floor = surface(from, from - up * wall_height * stance.scale);
    if (!floor || !can_stand_on(*floor, up)) return {};
    return floor->at;
}

}  // namespace

TeleportArc teleport_arc(const Stance& stance, const RoomPose& aim, const SurfaceBetween& surface) {
    TeleportArc out;
    const Eigen::Vector3d up = stance.up(), thrown = aim.ahead() * speed;
    std::optional<Eigen::Vector3d> on_floor;  // of the room
    Eigen::Vector3d last = aim.at;
    out.points.push_back(in_scene(stance, last));
    for (double t = step; t < longest && last.y() > -deepest; t += step) {
        const Eigen::Vector3d next = aim.at + t * thrown - Eigen::Vector3d(0, gravity * t * t / 2, 0);
        if (!on_floor && last.y() > 0 && next.y() <= 0) {
            const double share = last.y() / (last.y() - next.y());
            on_floor = in_scene(stance, last + share * (next - last));
        }
        const Eigen::Vector3d to = in_scene(stance, next);
        if (const auto hit = surface(out.points.back(), to)) {
            out.points.push_back(hit->at);
            out.landing = can_stand_on(*hit, up) ? hit->at : foot_of(*hit, stance, surface);
            return out;
        }
        out.points.push_back(to);
        last = next;
    }
    if (!on_floor) return out;
    // The model has no floor there: removes the points below the room's floor.
    while (out.points.size() > 1 && in_room(stance, out.points.back()).y() < 0) out.points.pop_back();
    out.points.push_back(*on_floor);
    out.landing = on_floor;
    return out;
}

}  // namespace vantage
