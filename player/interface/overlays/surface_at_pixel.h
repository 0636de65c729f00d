#pragma once
#include <Eigen/Core>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/plan/views/view_plan.h"

namespace vantage {

/// Where the ray through a pixel (0, 0: the corner of the frame) meets the plane of the triangle that was
/// seen there; relative to the origin. Nothing outside the frame, beside the mesh, or where the ray runs
/// along the triangle.
std::optional<Eigen::Vector3d> surface_at_pixel(const PlanScene& scene, const SeenTriangles& seen,
                                                const Eigen::Vector2d& pixel);

}  // namespace vantage
