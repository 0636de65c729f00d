#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "colors/shared_discs.h"
#include "pipeline/stages/surface_samples.h"
#include "scene/package_format.h"

namespace vantage {

/// Two photos that share surface.
struct PhotoPair {
    std::uint32_t a, b;    ///< a < b
    std::uint32_t shared;  ///< number of discs that both show
    double angle = 0;      ///< median angle between their rays to those discs, radians
    double color = 0;      ///< median |ln ratio| of linear light, mean of the channels
};

/// For each photo up to `per_photo` others that share the most surface from similar directions; each pair
/// once, sorted by (a, b). A pair shares at least 30 discs. Counts shared discs for all pairs with bit
/// operations, and computes angles and colors only for candidates.
std::vector<PhotoPair> photo_pairs(std::span<const package::PhotoRecord> photos, Samples samples,
                                   std::span<const SurfaceDisc> discs, std::size_t per_photo);

}  // namespace vantage
