#pragma once
#include <Eigen/Core>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/plan/views/view_plan.h"

namespace vantage {

/// Intersection of the ray through a pixel (0, 0: the frame's upper left corner) with the plane of the
/// triangle visible there, relative to the origin. Returns nullopt outside the frame, in the background, or
/// if the ray is parallel to the triangle.
std::optional<Eigen::Vector3d> surface_at_pixel(const PlanScene& scene, const SeenTriangles& seen,
                                                const Eigen::Vector2d& pixel);

}  // namespace vantage
