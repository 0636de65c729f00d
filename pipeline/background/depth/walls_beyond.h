#pragma once
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// Upright planes beyond the mesh on which many of the depths found lie, such as the facade across the
/// street; the largest first, at most three, each with 6 % of the shown directions (RANSAC, Fischler
/// and Bolles 1981). Deterministic.
std::vector<Plane> walls_beyond(const SweptDepths& depths, const DirectionSphere& sphere,
                                const std::vector<float>& inverse, const Eigen::Vector3d& down);

}  // namespace vantage
