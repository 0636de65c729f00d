#pragma once
#include <cstdint>

#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The photo from whose position an image set is first shown. This is the photo of the scene's first view or,
/// if that photo belongs to another image set, the photo of this image set that is nearest to it. If the
/// scene has no first view, it is the first photo with pixels. Returns the number of photos if none has
/// pixels.
std::uint32_t first_photo(const PackageReader& package, std::uint32_t image_set = 0);

/// The thumbnail of the first image set's first photo. Throws Error(input) if no photo has pixels, and
/// Error(damaged) if the thumbnail is damaged.
RgbaImage first_thumbnail(const PackageReader& package);

}  // namespace vantage
