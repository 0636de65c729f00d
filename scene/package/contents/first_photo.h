#pragma once
#include <cstdint>

#include "scene/package/package_reader.h"

namespace vantage {

/// The photo of an image set from whose place it is shown first: that of the scene's first view, or the one
/// of the image set nearest to it. The first with pixels if the scene has no first view; the number of photos
/// if none has.
std::uint32_t first_photo(const PackageReader& package, std::uint32_t image_set = 0);

}  // namespace vantage
