#pragma once
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// Finds up to three vertical planes beyond the mesh that each contain the depths of at least 6 % of the
/// shown directions, such as the facade across the street, by RANSAC (Fischler and Bolles 1981). The largest
/// comes first. Deterministic.
std::vector<Plane> walls_beyond(const SweptDepths& depths, const DirectionSphere& sphere,
                                const std::vector<float>& inverse, const Eigen::Vector3d& down);

}  // namespace vantage
