#pragma once
#include <span>

#include "player/plan/selection/sampling.h"
#include "player/plan/selection/tile_needs.h"
#include "player/view/view.h"

namespace vantage {

/// Samples of a surface, each of which represents `pixels` samples of the picture.
struct SampledSurface {
    std::span<const SurfaceSample> samples;
    std::span<const float> weights;  ///< per sample, in [0, 1]; 0: the photo does not show it
    double pixels = 1;
};

/// The tiles of one photo worth loading for these samples: those with at least the fraction `worth` of their
/// texels visible (twice that for weight maps, which come with depth). `lens`: null if the photo has no lens
/// table. A tile with a smaller fraction is replaced with the next coarser one; at the coarsest level all
/// tiles are listed. `coarse`: an additional level of the weight maps, used if it is coarser than the
/// samples' levels.
TileNeeds shown_tiles(const package::PhotoRecord& photo, const LensTable* lens, const Pose& photo_from_origin,
                      const SampledSurface& surface, double worth, double coarse = 0);

}  // namespace vantage
