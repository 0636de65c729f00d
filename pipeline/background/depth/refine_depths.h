#pragma once
#include <span>
#include <vector>

#include "pipeline/background/depth/depth_sweep.h"

namespace vantage {

/// Inverse distances on the sphere that divides the coarse one once more. Where depth is smooth, they are
/// interpolated; at its edges each direction takes the depth of a neighbor for which photos speak, so that
/// edges follow the photos (by iterated conditional modes, Besag 1986). `coarse`: as swept; `inverse`: found
/// for it.
std::vector<float> refine_depths(std::span<const CoarseView> views, const ScenePlanes& planes,
                                 const SweptDepths& coarse, const std::vector<float>& inverse,
                                 const DirectionSphere& fine, unsigned threads);

}  // namespace vantage
