#pragma once
#include <cstdint>
#include <vector>

#include "pipeline/synth/building.h"
#include "pipeline/synth/ray_scene.h"
#include "scene/camera.h"

namespace vantage {

/// What the camera photographs, lens included: sRGB, 3 bytes a pixel, first row on top, `samples` along a
/// pixel's side, light times `gain`. `rays` are of the model's mesh; both in the coordinates of the pose.
std::vector<std::uint8_t> cast_photo(const SynthModel& model, const RayScene& rays, const Camera& camera,
                                     int samples, double gain);

/// Linear z at pixel centres of the pinhole camera, +inf beside the model.
std::vector<float> cast_depth(const RayScene& rays, const Camera& camera);

}  // namespace vantage
