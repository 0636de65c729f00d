#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "player/headset/locomotion/stance.h"
#include "player/survey/scene_point.h"

namespace vantage {

/// The first surface point on the segment between two points.
using SurfaceBetween =
    std::function<std::optional<SurfacePoint>(const Eigen::Vector3d& from, const Eigen::Vector3d& to)>;

/// The ballistic arc of a teleport and its landing point.
struct TeleportArc {
    std::vector<Eigen::Vector3d> points;     ///< in the scene
    std::optional<Eigen::Vector3d> landing;  ///< nullopt: no place to stand
};

/// Starts at a hand, in its pointing direction. Lands on surfaces with a slope of at most 45 degrees, and
/// half a meter in front of walls. If the arc meets no surface down to three meters below the room's floor,
/// lands at the height of the room's floor.
TeleportArc teleport_arc(const Stance& stance, const RoomPose& aim, const SurfaceBetween& surface);

}  // namespace vantage
