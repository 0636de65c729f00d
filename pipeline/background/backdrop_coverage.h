#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/background/backdrop.h"
#include "scene/package/package_format.h"

namespace vantage {

/// Triangles per cluster of a backdrop: the 256 pieces of one coarser triangle.
inline constexpr std::uint32_t backdrop_cluster = 256;

/// The backdrop's clusters in the form of CLUS, but without culling by normals.
std::vector<package::ClusterRecord> backdrop_clusters(const Backdrop& backdrop);

/// A photo's coverage of each of the backdrop's clusters, as stored in COVR: the region of the photo that the
/// mesh does not cover. `gaps` is the result of gaps_in() for this view.
std::vector<package::CoverageRecord> backdrop_coverage(const Backdrop& backdrop,
                                                       std::span<const package::ClusterRecord> clusters,
                                                       const CoarseView& view,
                                                       std::span<const std::uint8_t> gaps);

}  // namespace vantage
