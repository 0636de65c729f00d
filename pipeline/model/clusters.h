#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scene/package_format.h"

namespace vantage {

/// Orders the triangles along a space-filling curve and cuts them into runs of at most `cluster_triangles`,
/// each with a bounding sphere and a normal cone (meshoptimizer); runs of large triangles further,
/// until a cluster looks one way and is small beside the scene. `indices` is reordered in place.
std::vector<package::ClusterRecord> make_clusters(const std::vector<Eigen::Vector3f>& positions,
                                                  std::vector<std::uint32_t>& indices,
                                                  std::uint32_t cluster_triangles);

}  // namespace vantage
