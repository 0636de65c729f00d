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

/// A photo to be searched for sky on the mesh.
struct SkyPicture {
    Intrinsics k;
    Pose pose;        ///< relative to the origin
    cv::Mat3f codes;  ///< square roots of linear light times 255, or NaN if there is no pixel
    cv::Mat1f z;      ///< depth of the mesh, +inf in open texels
    cv::Mat1b sky;    ///< 1 if open and sky
};

/// The views' photos at the finest level with at most 768 texels on the longer side. Throws Error(damaged).
std::vector<SkyPicture> read_sky_pictures(const PackageReader& package,
                                          std::span<const package::PhotoRecord> photos,
                                          std::span<const CoarseView> views, const Sky& sky,
                                          unsigned threads);

/// Marks texels of the mesh whose color continues that of the sky next to it: 1 if they are connected to open
/// sky without an edge; 2 if they are also overexposed, and so may show a white wall as well as sky.
cv::Mat1b sky_on_mesh(const SkyPicture& picture);

/// The triangles that the photos show as sky, in ascending order: a surface reconstructed from the sky, such
/// as a membrane between roofs. The result consists of triangles that most photos show as sky, and of
/// triangles connected to them that many photos show as sky. Triangles below the horizon or visible in only
/// one photo are never included.
std::vector<std::uint32_t> sky_triangles(std::span<const Eigen::Vector3f> positions,
                                         std::span<const std::array<std::uint32_t, 3>> triangles,
                                         std::span<const SkyPicture> pictures, const Eigen::Vector3f& down,
                                         unsigned threads);

}  // namespace vantage
