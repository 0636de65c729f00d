#pragma once
#include <span>

#include "player/plan/sampling.h"
#include "player/plan/tile_needs.h"
#include "player/view.h"

namespace vantage {

/// Which tiles of one photo are worth having to show these samples, each of which stands for `pixels` samples
/// of the picture: those of whose texels at least the share `worth` would be shown. Where a tile is not, the
/// next coarser one shows its part as well; on the coarsest level every tile is worth it. Of masks, which
/// come with depth, twice the share.
TileNeeds shown_tiles(const package::PhotoRecord& photo, const Intrinsics& intrinsics,
                      const Pose& photo_from_origin, std::span<const SurfaceSample> samples, double pixels,
                      double worth);

}  // namespace vantage
