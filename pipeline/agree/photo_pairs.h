#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/agree/shared_discs.h"
#include "pipeline/stages/surface_samples.h"
#include "scene/package_format.h"

namespace vantage {

/// Two photos that show some of the same surface.
struct PhotoPair {
    std::uint32_t a, b;    ///< a < b
    std::uint32_t shared;  ///< discs that both show
    double angle = 0;      ///< between their directions to that surface, radians, median
    double color = 0;      ///< median |ln ratio| of the discs' linear light, mean of the channels
};

/// For each photo the `most` others that show most of what it shows from nearly the same direction, each pair
/// once, in order. A pair shares 30 discs at least. Time: a few operations a disc for all pairs, and the
/// angles and colours of those that are near.
std::vector<PhotoPair> photo_pairs(std::span<const package::PhotoRecord> photos, Samples samples,
                                   std::span<const SurfaceDisc> discs, std::size_t most);

}  // namespace vantage
