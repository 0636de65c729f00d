#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/planned_photo.h"

namespace vantage {

/// The share of each photo among those taken nearest to the viewer, which show what is near of the
/// background; it changes continuously with the viewer. They sum to 1. One per photo, in place of
/// what is in `shares`.
void find_nearest_shares(const PlanScene& scene, const Eigen::Vector3d& eye, std::vector<float>& shares);

/// How far the nearest photos show the background, not those that it is labeled with; at their own cameras
/// infinitely far.
double near_distance(const PlanScene& scene, const Eigen::Vector3d& eye);

/// The photos that show the background in view: those whose labels it has, and the nearest. Instead of the
/// agreement, their shares among the nearest.
std::vector<PlannedPhoto> plan_background(const VisibleSurface& surface, const PlanSettings& settings,
                                          std::span<const std::uint32_t> allowed);

}  // namespace vantage
