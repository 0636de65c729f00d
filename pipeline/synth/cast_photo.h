#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/synth/building.h"
#include "pipeline/synth/ray_scene.h"
#include "scene/camera.h"

namespace vantage {

/// How a photo is exposed: light times the gain of each channel, and times 1/(1 + a r^2)^2, r = 1 at half the
/// diagonal from the principal point, with which `falloff` of it is lost there.
struct PhotoExposure {
    std::array<double, 3> gain{1, 1, 1};
    double falloff = 0;
};

/// What the camera photographs, lens included: sRGB, 3 bytes a pixel, first row on top, `samples` along a
/// pixel's side. `rays` are of the model's mesh; both in the coordinates of the pose.
std::vector<std::uint8_t> cast_photo(const SynthModel& model, const RayScene& rays, const Camera& camera,
                                     int samples, const PhotoExposure& exposure = {});

/// Linear z at pixel centres of the pinhole camera, +inf beside the model.
std::vector<float> cast_depth(const RayScene& rays, const Camera& camera);

}  // namespace vantage
