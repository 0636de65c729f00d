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

/// A small disc of the model's surface: photos that see it should show it in one colour.
struct SurfaceDisc {
    Eigen::Vector3f center, normal;  ///< of either sign; zero where the triangle has none
    float radius;
};

/// How many discs every model has.
inline constexpr std::size_t surface_discs = 8192;

/// The level of the tile pyramid, or the coarsest above it, from which photos are sampled.
inline constexpr int sample_level = 2;

/// Discs spread over the model, half of them by area and half by triangles, so that neither a large ground
/// nor a dense mesh takes them all; the same for the same model. `density`: pixels per unit of the finest
/// photo, in which a disc is 48 pixels in radius. Empty where the model has no triangle.
std::vector<SurfaceDisc> surface_disc_set(std::span<const Eigen::Vector3f> positions,
                                          std::span<const std::uint32_t> indices, double density);

/// The mean colour of each disc in a photo, in linear light; a zero record where less than five sixths of it
/// is seen, where it is seen at a grazing angle or too small, and where a channel is nearly black or white
/// (sRGB below 15 or above 240). `photo`: its pixels at `sample_level`; `geometry` at `mask_level`.
std::vector<package::SampleRecord> sample_discs(std::span<const SurfaceDisc> discs, RgbaImage photo,
                                                const PhotoGeometry& geometry, const Intrinsics& intrinsics,
                                                const Pose& cam_from_origin);

/// Distance from the principal point over half the photo's diagonal: the r of a lens's falloff.
double falloff_radius(const Intrinsics& intrinsics, const Eigen::Vector2d& pixel);

}  // namespace vantage
