#pragma once
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// Uses RANSAC (Fischler and Bolles 1981) to find up to three vertical planes beyond the mesh, such as the
/// facade across the street. Each plane contains the depths of at least 6 % of the shown directions. The
/// largest comes first. Deterministic.
std::vector<Plane> walls_beyond(const SweptDepths& depths, const DirectionSphere& sphere,
                                const std::vector<float>& inverse, const Eigen::Vector3d& down);

}  // namespace vantage
