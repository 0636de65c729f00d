#pragma once
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// The cost of a step between neighbors, from the difference of their inverse distances.
float step_cost(float difference, double reach);

/// The inverse distance of each direction: the labels with the smallest sum of costs and of differences
/// between neighbors, by belief propagation (Felzenszwalb and Huttenlocher 2006), and exactly on a plane
/// that is next to them. Directions that no photo shows continue their neighbors.
std::vector<float> inverse_distances(const SweptDepths& depths, const DirectionSphere& sphere);

}  // namespace vantage
