#pragma once
#include "base/values/rgba_image.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The photo with which the player opens, or the nearest one with a thumbnail, as a picture of at most
/// `longest` px on the longer side, but never larger than the thumbnail in the package. Throws Error(input)
/// if there is no photo, Error(damaged) if its thumbnail is damaged.
RgbaImage thumbnail(const PackageReader& package, int longest);

}  // namespace vantage
