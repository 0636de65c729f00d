#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "player/plan/planned_photo.h"

namespace vantage {

/// The weights of the photos taken nearest to the viewer, which show nearby parts of the background. The
/// weights sum to 1 and change continuously as the viewer moves. Replaces the content of `shares` with one
/// weight per photo of the scene.
void find_nearest_shares(const PlanScene& scene, const Eigen::Vector3d& eye, std::vector<float>& shares);

/// Distance up to which the nearest photos show the background instead of its labeled photos; infinite if the
/// viewer is close to a camera.
double near_distance(const PlanScene& scene, const Eigen::Vector3d& eye);

/// The photos that show the background in view: its labeled photos, and the nearest ones. Each photo's
/// `agreement` is its weight among the nearest photos.
std::vector<PlannedPhoto> plan_background(const VisibleSurface& surface, const PlanSettings& settings,
                                          std::span<const std::uint32_t> allowed);

}  // namespace vantage
