#pragma once
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// The cost of a step between neighbors, from the difference of their inverse distances.
float step_cost(float difference, double reach);

/// The inverse distance of each direction: the labels with the smallest sum of data costs and step costs
/// between neighbors, by belief propagation (Felzenszwalb and Huttenlocher 2006), snapped to a plane that is
/// within one label, if there is one. Unseen directions are extrapolated from their neighbors.
std::vector<float> inverse_distances(const SweptDepths& depths, const DirectionSphere& sphere);

}  // namespace vantage
