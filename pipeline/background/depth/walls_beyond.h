#pragma once
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// Vertical planes beyond the mesh that contain many of the depths, such as the facade across the street; the
/// largest first, at most three, each with at least 6 % of the shown directions (RANSAC, Fischler and Bolles
/// 1981). Deterministic.
std::vector<Plane> walls_beyond(const SweptDepths& depths, const DirectionSphere& sphere,
                                const std::vector<float>& inverse, const Eigen::Vector3d& down);

}  // namespace vantage
