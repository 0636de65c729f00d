#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// Orders the triangles along a space-filling curve and cuts them into clusters of at most
/// `cluster_triangles` triangles, each with a bounding sphere and a normal cone (meshoptimizer). Clusters of
/// large triangles are split further, until they are small relative to the scene and all their triangles face
/// roughly the same direction. Reorders `indices` in place. `scene` is the model's box without vertices far
/// outside it; if it is empty, the box of all vertices is used.
std::vector<package::ClusterRecord> make_clusters(const std::vector<Eigen::Vector3f>& positions,
                                                  std::vector<std::uint32_t>& indices,
                                                  std::uint32_t cluster_triangles,
                                                  const Eigen::AlignedBox3f& scene = {});

}  // namespace vantage
