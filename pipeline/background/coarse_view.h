#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "scene/agreement/color_fit.h"
#include "scene/camera/camera.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// ln of linear light for comparison; the offset keeps noise in dark pixels from becoming large differences.
inline constexpr float ln_offset = 0.02f;
inline Eigen::Array3f ln_of(const Eigen::Array3f& linear) { return (linear + ln_offset).log(); }
inline Eigen::Array3f linear_of(const Eigen::Array3f& ln) { return ln.exp() - ln_offset; }

/// Square roots of light, which are roughly perceptually uniform.
inline Eigen::Array3f root_of(const Eigen::Array3f& ln) { return linear_of(ln).max(0.0f).sqrt(); }

inline constexpr int gap_reach = 2;  ///< texels

/// A photo at a coarse level, with its open texels: those that do not show the mesh.
struct CoarseView {
    std::uint32_t photo = 0;
    Intrinsics k;  ///< for this level
    Pose pose;     ///< relative to the origin
    /// ln_of() of linear light at the photos' mean exposure, or NaN where the photo has no pixel or shows the
    /// mesh.
    std::vector<Eigen::Array3f> ln;
    std::vector<float> z;              ///< depth of the mesh, +inf in open texels
    std::size_t pixels = 0, open = 0;  ///< number of texels with a pixel, and number of open texels

    bool is_open(std::size_t texel) const { return !std::isnan(ln[texel][0]); }
};

/// Transforms a position relative to the origin into the view's camera space.
inline Eigen::Vector3f in_camera(const CoarseView& view, const Eigen::Vector3f& position) {
    return (view.pose.R * position.cast<double>() + view.pose.t).cast<float>();
}

/// Reads the photos listed in `of` at the finest level with at most 192 texels on the longer side. `colors`
/// contains the gains and vignetting of all photos of the scene. Throws Error(damaged).
std::vector<CoarseView> read_coarse_views(const PackageReader& package,
                                          std::span<const package::PhotoRecord> photos,
                                          std::span<const std::uint32_t> of, const PhotoColors& colors,
                                          unsigned threads);

/// For each texel of the view, 1 if any texel within `gap_reach` is open at `weight_map_level`. Throws
/// Error(damaged).
std::vector<std::uint8_t> gaps_in(const CoarseView& view, const PackageReader& package,
                                  const package::PhotoRecord& record);

/// Views and the color corrections applied to them.
struct CoarseViews {
    std::vector<CoarseView> views;
    PhotoColors colors;
};

/// At most `most` photos with pixels, spread over the camera positions by farthest-point sampling.
std::vector<std::uint32_t> spread_photos(std::span<const package::PhotoRecord> photos, std::size_t most);

}  // namespace vantage
