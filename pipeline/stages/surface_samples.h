#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/pixels/rgba_image.h"
#include "pipeline/visibility/photo_geometry.h"
#include "scene/camera.h"
#include "scene/package_format.h"

namespace vantage {

/// A small disc on the model's surface, at which photos are compared.
struct SurfaceDisc {
    Eigen::Vector3f center, normal;  ///< the normal has either sign, and is 0 on a degenerate triangle
    float radius;
};

/// Photos are sampled at this level of the pyramid or coarser.
inline constexpr int sample_level = 2;

/// Discs spread over the model, half by area and half by triangle count, so that neither a large ground plane
/// nor a dense object takes them all. Deterministic. Their radius is 48 px at `density` (pixels per unit of
/// the finest photo). Empty if the model has no triangles.
std::vector<SurfaceDisc> surface_disc_set(std::span<const Eigen::Vector3f> positions,
                                          std::span<const std::uint32_t> indices, double density);

/// The mean color of each disc in a photo, in linear light. A record is zero if less than five sixths of the
/// disc is seen, the cosine of the viewing angle is at most 0.2, the foreshortened radius is below 6 px, or a
/// channel is below sRGB 15 or above 240. `photo`: its pixels at `sample_level`; `geometry`: at `mask_level`.
std::vector<package::SampleRecord> sample_discs(std::span<const SurfaceDisc> discs, RgbaImage photo,
                                                const PhotoGeometry& geometry, const Intrinsics& intrinsics,
                                                const Pose& cam_from_origin);

/// Distance from the principal point over half the photo's diagonal: the r of the lens falloff.
double falloff_radius(const Intrinsics& intrinsics, const Eigen::Vector2d& pixel);

}  // namespace vantage
