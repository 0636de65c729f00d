#pragma once
#include <span>

#include "player/plan/selection/sampling.h"
#include "player/plan/selection/tile_needs.h"
#include "player/view/view.h"

namespace vantage {

/// The tiles of one photo worth loading to show these samples, each of which stands for `pixels` samples of
/// the picture: those with at least the share `worth` of their texels shown (twice that for weight maps,
/// which come with depth). `lens`: null if the photo has none. A tile below that is replaced by the next
/// coarser one; on the coarsest level all tiles count.
TileNeeds shown_tiles(const package::PhotoRecord& photo, const LensTable* lens, const Pose& photo_from_origin,
                      std::span<const SurfaceSample> samples, double pixels, double worth);

}  // namespace vantage
