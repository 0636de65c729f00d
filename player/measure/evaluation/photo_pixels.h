#pragma once
#include "player/render/picture.h"
#include "player/view/view.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A photo, resampled to a pinhole camera, at the size of a pyramid level, computed from its finest level:
/// stored coarser levels may be rounded, see FORMAT.md. Throws Error(damaged) for a checksum mismatch,
/// std::invalid_argument if the photo has no such level.
Picture photo_at_level(const PackageReader& package, std::uint32_t photo, int level);

/// One level of a photo's weight maps, assembled from its tiles. Throws like photo_at_level().
Picture weight_maps_at_level(const PackageReader& package, std::uint32_t photo, int level);

/// The photo's own camera, with that level's texels as pixels.
View view_of_level(const package::PhotoRecord& photo, int level);

}  // namespace vantage
