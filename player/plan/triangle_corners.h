#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/view/ray.h"

namespace vantage {

using Corners = std::array<Eigen::Vector3d, 3>;

/// The corners of a triangle, numbered from 0. Returns nullopt if the file was overwritten and an index is
/// out of range.
std::optional<Corners> corners_of(const PlanScene& scene, std::uint32_t triangle);

/// The distance along a ray to a triangle, in lengths of the ray's direction (Moeller and Trumbore 1997); NaN
/// if they do not intersect. `slack`: tolerance in barycentric coordinates.
double meets(const Ray& ray, const Corners& corners, double slack);

}  // namespace vantage
