#pragma once
#include <span>

#include "player/camera/view.h"
#include "player/plan/sampling.h"
#include "player/plan/tile_needs.h"

namespace vantage {

/// The tiles of one photo worth having to show these samples, each of which stands for `pixels` samples of
/// the picture: those with at least the share `worth` of their texels shown (of masks, which come with depth,
/// twice that). The next coarser tile shows the part of a tile that is not worth it; on the coarsest level
/// every tile is.
TileNeeds shown_tiles(const package::PhotoRecord& photo, const Intrinsics& intrinsics,
                      const Pose& photo_from_origin, std::span<const SurfaceSample> samples, double pixels,
                      double worth);

}  // namespace vantage
