#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/planned_photo.h"

namespace vantage {

/// The weight of each photo among those taken nearest to the viewer, which show nearby parts of the
/// background; it changes continuously with the viewer. The weights sum to 1. One per photo; replaces the
/// content of `shares`.
void find_nearest_shares(const PlanScene& scene, const Eigen::Vector3d& eye, std::vector<float>& shares);

/// Distance up to which the nearest photos show the background instead of its labeled photos; infinite if the
/// viewer is close to a camera.
double near_distance(const PlanScene& scene, const Eigen::Vector3d& eye);

/// The photos that show the background in view: its labeled photos, and the nearest ones. `agreement` is
/// their weight among the nearest.
std::vector<PlannedPhoto> plan_background(const VisibleSurface& surface, const PlanSettings& settings,
                                          std::span<const std::uint32_t> allowed);

}  // namespace vantage
