#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

#include "player/headset/locomotion/room_pose.h"

namespace vantage {

/// Where the room stands in the scene, level: p in the room is at `at + scale * R * p`, relative to the
/// package's origin.
struct Stance {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< takes the room's up to the scene's
    Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< of the middle of the room's floor
    double scale = 1;                                 ///< scene units per meter

    Eigen::Vector3d up() const { return R.col(1); }
};

Eigen::Vector3d in_scene(const Stance& stance, const Eigen::Vector3d& room);
Eigen::Vector3d in_room(const Stance& stance, const Eigen::Vector3d& scene);

/// A stance in which the head is at `eye` in the scene and looks toward `target` as far as it is level, with
/// `up` (of length 1) as the scene's up. A target straight above or below is looked at from any side.
Stance standing(const RoomPose& head, const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                const Eigen::Vector3d& up, double scale);

/// At another scale, in scene units per meter, with a point of the scene where it was.
Stance rescaled(Stance stance, const Eigen::Vector3d& about, double scale);
/// Turned to the left about the head by an angle in radians.
Stance turned(const Stance& stance, const RoomPose& head, double angle);
/// Moved in the scene.
Stance moved(Stance stance, const Eigen::Vector3d& by);
/// Moved so that the head is above `point`, which is on the floor.
Stance stood_on(Stance stance, const RoomPose& head, const Eigen::Vector3d& point);

/// What hands held when they closed: the room's stance then, and where in the room they were.
struct Hold {
    Stance stance;
    std::array<Eigen::Vector3d, 2> hands;
    std::size_t count = 0;  ///< 1 or 2
};
/// The stance in which what is held stays in the hands, `hands` being where they are now. One hand moves the
/// scene; two also turn it about up and scale it, to between `smallest` and `largest` scene units per meter.
Stance held(const Hold& hold, std::span<const Eigen::Vector3d> hands, double smallest, double largest);

}  // namespace vantage
