#pragma once
#include "player/camera/view.h"
#include "player/render/picture.h"
#include "scene/package_reader.h"

namespace vantage {

/// One pyramid level of a photo (package::Type::tiles) or of its masks, assembled from its tiles. Throws
/// Error(damaged) for a checksum mismatch, std::invalid_argument if the photo has no such level.
Picture level_of_photo(const PackageReader& package, package::Type type, std::uint32_t photo, int level);

/// The photo's own camera, with the texels of that level as pixels.
View view_of_level(const package::PhotoRecord& photo, int level);

}  // namespace vantage
