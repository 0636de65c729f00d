#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

#include "player/headset/locomotion/room_pose.h"

namespace vantage {

/// Similarity transform from the room to the scene that keeps the floor level: the point p of the room is at
/// `at + scale * R * p`, relative to the package's origin.
struct Stance {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< rotates the room's up direction to the scene's
    Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< center of the room's floor
    double scale = 1;                                 ///< scene units per meter

    Eigen::Vector3d up() const { return R.col(1); }
};

Eigen::Vector3d in_scene(const Stance& stance, const Eigen::Vector3d& room);
Eigen::Vector3d in_room(const Stance& stance, const Eigen::Vector3d& scene);

/// A stance with the head at `eye` in the scene, facing `target` in the horizontal plane, with the unit
/// vector `up` as the scene's up direction. If the target is straight above or below, the heading is
/// arbitrary.
Stance standing(const RoomPose& head, const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                const Eigen::Vector3d& up, double scale);

/// Changes the scale, in scene units per meter, and keeps a point of the scene in place.
Stance rescaled(Stance stance, const Eigen::Vector3d& about, double scale);
/// Turns the stance to the left about the head, by an angle in radians.
Stance turned(const Stance& stance, const RoomPose& head, double angle);
/// Translates the stance in the scene.
Stance moved(Stance stance, const Eigen::Vector3d& by);
/// Translates the stance so that the head is above `point`, which is on the floor.
Stance stood_on(Stance stance, const RoomPose& head, const Eigen::Vector3d& point);

/// State when the hands grabbed the scene: the room's stance and the hands' positions in the room.
struct Hold {
    Stance stance;
    std::array<Eigen::Vector3d, 2> hands;
    std::size_t count = 0;  ///< 1 or 2
};
/// The stance that keeps grabbed points in the hands, whose current positions are `hands`. One hand moves the
/// scene; two hands also turn it about the up direction and scale it, to between `smallest` and `largest`
/// scene units per meter.
Stance held(const Hold& hold, std::span<const Eigen::Vector3d> hands, double smallest, double largest);

}  // namespace vantage
