#pragma once
#include <Eigen/Core>
#include <span>

#include "player/plan/plan_scene.h"

namespace vantage {

/// A ball relative to the scene's origin.
struct Ball {
    Eigen::Vector3d center;
    double radius;
};

/// Hides the mesh's triangles whose centers are in a ball, by collapsing them to a point. Background vertices
/// in a ball lose their photos, and get colors interpolated from the vertices around them. Parts that an
/// earlier call has hidden are shown again. No other thread may use the scene at the same time.
void hide(PlanScene& scene, std::span<const Ball> balls);

}  // namespace vantage
