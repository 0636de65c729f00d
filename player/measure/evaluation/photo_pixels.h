#pragma once
#include "player/render/picture.h"
#include "player/view/view.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A photo, resampled to a pinhole camera, at the size of a pyramid level. The picture is computed from the
/// photo's finest level, because stored coarser levels may be rounded, see FORMAT.md. Throws Error(damaged)
/// if a checksum does not match, std::invalid_argument if the photo has no such level.
Picture photo_at_level(const PackageReader& package, std::uint32_t photo, int level);

/// One level of a photo's weight maps, assembled from its tiles. Throws the errors of photo_at_level().
Picture weight_maps_at_level(const PackageReader& package, std::uint32_t photo, int level);

/// The view of the photo's own camera whose pixels are the texels of a level.
View view_of_level(const package::PhotoRecord& photo, int level);

}  // namespace vantage
