#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "player/plan/plan_scene.h"
#include "player/view/view.h"

namespace vantage {

/// The value of a scalar field at the intersection of the ray through a pixel (0, 0: the frame's upper left
/// corner) with a triangle, numbered from 0. Returns nullopt in the background, if a corner has no value, or
/// if the ray is parallel to the triangle.
std::optional<double> value_at_pixel(const PlanScene& scene, std::span<const float> values,
                                     std::uint32_t triangle, const View& view, const Eigen::Vector2d& pixel);

}  // namespace vantage
