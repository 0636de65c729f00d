#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/background/backdrop.h"
#include "scene/package/package_format.h"

namespace vantage {

/// Triangles per cluster of a backdrop: the 256 pieces of a larger one.
inline constexpr std::uint32_t backdrop_cluster = 256;

/// The backdrop's clusters, as in CLUS; without culling by normals.
std::vector<package::ClusterRecord> backdrop_clusters(const Backdrop& backdrop);

/// What a photo sees of each of the backdrop's clusters, as COVR says it of the mesh: where it is in the
/// photo and the mesh leaves it open. `gaps`: of the view.
std::vector<package::CoverageRecord> backdrop_coverage(const Backdrop& backdrop,
                                                       std::span<const package::ClusterRecord> clusters,
                                                       const CoarseView& view,
                                                       std::span<const std::uint8_t> gaps);

}  // namespace vantage
