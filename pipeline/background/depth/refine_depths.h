#pragma once
#include <span>
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// Inverse distances on the next subdivision of the coarse sphere. Smooth depths are interpolated; at depth
/// edges, each direction takes the depth of the neighbor with the lowest cost, so that edges follow the
/// photos (iterated conditional modes, Besag 1986). `coarse` is the result of sweep_depths(), and `inverse`
/// contains the smoothed depths on the coarse sphere.
std::vector<float> refine_depths(std::span<const CoarseView> views, const ScenePlanes& planes,
                                 const SweptDepths& coarse, const std::vector<float>& inverse,
                                 const DirectionSphere& fine, unsigned threads);

}  // namespace vantage
