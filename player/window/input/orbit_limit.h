#pragma once
#include <Eigen/Core>

#include "player/interface/state/session.h"
#include "player/plan/plan_scene.h"

namespace vantage {

/// Turns the camera about a point by angles in radians, as orbit_about() does. If the session stays near the
/// photos, turning away from them meets a resistance that grows beyond `free_angle` and is complete at twice
/// that angle.
void orbit_near_photos(Session& session, const PlanScene& scene, const Eigen::Vector3d& pivot, double right,
                       double down);

/// Moves the camera by a vector in its own axes, as fly() does. If the session stays near the photos, the
/// mesh stays in the picture. `view`: that of the camera.
void pan_near_photos(Session& session, const PlanScene& scene, const View& view, const Eigen::Vector3d& by);

/// After a drag that went beyond `free_angle`, starts a flight back.
void return_to_photos(Session& session, double now);

/// The largest distance when zooming out, in scene units: that of the session or, if it has none and stays
/// near the photos, that at which the mesh fills a fifth of the height. For a flat mesh, a quarter of its
/// diagonal counts as its height.
double farthest_distance(Session& session, const PlanScene& scene);

}  // namespace vantage
