#pragma once
#include "scene/camera.h"
#include "values/rgba_image.h"

namespace vantage {

/// Largest displacement by the lens relative to a pinhole camera, in pixels, sampled on a grid over the
/// photo. 0 for a camera without distortion; never NaN.
double largest_displacement(const Camera& camera);

/// Resamples the photo to the pinhole camera of the same intrinsics, by bicubic interpolation (OpenCV).
/// Pixels whose ray is outside the photo get alpha 0.
RgbaImage undistort(const RgbaImage& photo, const Camera& camera);

}  // namespace vantage
