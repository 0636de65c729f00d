#pragma once
#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A picture of the photo with which the player opens, or of the nearest photo with a thumbnail. Its longer
/// side has at most `longest` px, but the picture is never larger than the thumbnail in the package. Throws
/// Error(input) if there is no photo, and Error(damaged) if the thumbnail is damaged.
RgbaImage thumbnail(const PackageReader& package, int longest);

}  // namespace vantage
