#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "player/plan/plan_scene.h"
#include "player/view/view.h"

namespace vantage {

/// The value of a scalar field where the ray through a pixel (0, 0: the corner of the frame) meets a
/// triangle, numbered from 0. Nothing beside the mesh, where a corner has no value, or where the ray runs
/// along the triangle.
std::optional<double> value_at_pixel(const PlanScene& scene, std::span<const float> values,
                                     std::uint32_t triangle, const View& view, const Eigen::Vector2d& pixel);

}  // namespace vantage
