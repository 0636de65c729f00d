#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/mesh/ray_scene.h"
#include "pipeline/synth/building.h"
#include "scene/camera/camera.h"

namespace vantage {

/// Exposure of a photo. Linear light is multiplied by the gain of its channel and by 1 / (1 + a r^2)^2, where
/// r is the distance from the principal point in units of half the image's diagonal, and a is chosen so that
/// `vignetting` is the fraction of light lost at r = 1.
struct PhotoExposure {
    std::array<double, 3> gain{1, 1, 1};
    double vignetting = 0;
};

/// Spectral range of a photo.
enum class SynthImageSet { visible, infrared };

/// Renders the camera's photo, including lens distortion: sRGB, 3 bytes per pixel, top row first, with
/// `samples` x `samples` rays per pixel. `rays` is made from the model's mesh.
std::vector<std::uint8_t> cast_photo(const SynthModel& model, const RayScene& rays, const Camera& camera,
                                     int samples, const PhotoExposure& exposure = {},
                                     SynthImageSet image_set = SynthImageSet::visible);

/// Linear z at the camera's pixel centers, ignoring lens distortion, row by row from the top; +inf where the
/// ray misses the model.
std::vector<float> cast_depth(const RayScene& rays, const Camera& camera);

}  // namespace vantage
