#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"
#include "pipeline/background/sky.h"

namespace vantage {

/// A photo in which to look for sky on the mesh.
struct SkyPicture {
    Intrinsics k;
    Pose pose;        ///< relative to the origin
    cv::Mat3f codes;  ///< square roots of linear light times 255; NaN without a pixel
    cv::Mat1f z;      ///< of the mesh, +inf where it is open
    cv::Mat1b sky;    ///< 1 where it is open and shows sky
};

/// The views' photos at the finest level with at most 768 texels on the longer side. Throws Error(damaged).
std::vector<SkyPicture> read_sky_pictures(const PackageReader& package,
                                          std::span<const package::PhotoRecord> photos,
                                          std::span<const CoarseView> views, const Sky& sky,
                                          unsigned threads);

/// Where a photo shows on the mesh the same as beside it: 1, sky, which reaches there from open sky without
/// an edge; 2, it may be sky, but is overexposed, as a white wall would be.
cv::Mat1b sky_on_mesh(const SkyPicture& picture);

/// The triangles that the photos show as sky, ascending: a surface that was reconstructed from it, such as a
/// membrane between roofs. Those that nearly all photos show so, and those connected to them that most do;
/// none below the horizon, none that only one photo shows.
std::vector<std::uint32_t> sky_triangles(std::span<const Eigen::Vector3f> positions,
                                         std::span<const std::array<std::uint32_t, 3>> triangles,
                                         std::span<const SkyPicture> pictures, const Eigen::Vector3f& down,
                                         unsigned threads);

}  // namespace vantage
