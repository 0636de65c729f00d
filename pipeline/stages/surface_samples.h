#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/values/rgba_image.h"
#include "pipeline/stages/stage_input.h"
#include "pipeline/visibility/photo_geometry.h"
#include "scene/agreement/surface_discs.h"
#include "scene/camera/camera.h"
#include "scene/package/contents/lens_table.h"
#include "scene/package/package_format.h"

namespace vantage {

/// Photos are sampled at this level of the pyramid or coarser.
inline constexpr int sample_level = 2;

/// The mean color of each disc in a photo, in linear light. A record is zero if less than five sixths of the
/// disc is visible, if the cosine of the viewing angle is at most 0.2, if the foreshortened radius is below 6
/// px, or if a channel is below sRGB 15 or above 240. `photo` is the photo at `sample_level`; `geometry` is
/// at `weight_map_level`. `lens` is null for a pinhole camera.
std::vector<package::SampleRecord> sample_discs(std::span<const SurfaceDisc> discs, RgbaImage photo,
                                                const PhotoGeometry& geometry, const Intrinsics& intrinsics,
                                                const Pose& cam_from_origin, const LensTable* lens = nullptr);

/// The color sample stage: writes the color samples of all discs.
void make_samples(StageInput& in);

}  // namespace vantage
