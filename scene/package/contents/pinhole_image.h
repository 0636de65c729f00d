#pragma once
#include "base/values/rgba_image.h"
#include "scene/package/contents/lens_table.h"

namespace vantage {

/// A level of a photo's pyramid, as a pinhole camera with the same intrinsics would have captured it. The
/// photo is resampled only once, with Catmull-Rom interpolation. Alpha is 0 where the image of a pixel lies
/// outside the photo. Throws std::invalid_argument unless the photo has the size of that level.
RgbaImage pinhole_image(const RgbaImage& photo, const LensTable& table, int level);

}  // namespace vantage
