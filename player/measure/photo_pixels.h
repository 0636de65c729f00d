#pragma once
#include "player/render/picture.h"
#include "player/view.h"
#include "scene/package_reader.h"

namespace vantage {

/// One pyramid level of a photo (package::Type::tiles) or of its masks, put together from its tiles, at most
/// `level` and no finer than there is. Throws Error(damaged) where a tile's checksum is wrong,
/// std::invalid_argument for a photo without pixels.
Picture level_of_photo(const PackageReader& package, package::Type type, std::uint32_t photo, int level);

/// The photo's own camera, whose pixels are that level's texels.
View view_of_level(const package::PhotoRecord& photo, int level);

}  // namespace vantage
