#pragma once
#include <cstdint>

#include "scene/package/package_reader.h"

namespace vantage {

/// The photo from whose position an image set is first shown: the photo of the scene's first view, or else
/// the nearest one in the image set. If the scene has no first view, the first photo with pixels. The number
/// of photos if none has pixels.
std::uint32_t first_photo(const PackageReader& package, std::uint32_t image_set = 0);

}  // namespace vantage
