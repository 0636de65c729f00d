#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "player/headset/locomotion/stance.h"
#include "player/survey/scene_point.h"

namespace vantage {

/// The first point of the model on the way between two points.
using SurfaceBetween =
    std::function<std::optional<SurfacePoint>(const Eigen::Vector3d& from, const Eigen::Vector3d& to)>;

/// The way of something thrown to where one wants to stand, and where that is.
struct TeleportArc {
    std::vector<Eigen::Vector3d> points;     ///< in the scene
    std::optional<Eigen::Vector3d> landing;  ///< nothing: there is no place to stand
};

/// From a hand's aim. Lands on surfaces that are at most 45 degrees steep; at the foot of walls that it
/// meets, half a meter before them; and at the height of the room's floor where the model has none, within
/// three meters below.
TeleportArc teleport_arc(const Stance& stance, const RoomPose& aim, const SurfaceBetween& surface);

}  // namespace vantage
