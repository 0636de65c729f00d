#pragma once
#include "pipeline/pixels/rgba_image.h"
#include "pipeline/settings/settings.h"
#include "scene/camera.h"

namespace vantage {

/// Largest distance in pixels between where the lens and where the pinhole draws a pixel, sampled on a grid
/// over the photo. 0 for a pinhole; never NaN.
double largest_displacement(const Camera& camera);

/// Resamples the photo to the pinhole camera of the same intrinsics (OpenCV). Pixels whose ray the
/// photo does not hold get alpha 0.
RgbaImage undistort(const RgbaImage& photo, const Camera& camera, Resampling resampling);

}  // namespace vantage
