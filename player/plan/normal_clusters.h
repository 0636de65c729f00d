#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace vantage {

struct NormalCluster {
    Eigen::Vector3d direction;  ///< unit length
    std::size_t members;
};

/// Spherical k-means (Dhillon and Modha 2001): at most `clusters` directions of unit `normals`, by decreasing
/// number of members. Starts from normals far apart and runs `iterations`; omits empty clusters and
/// non-finite normals.
std::vector<NormalCluster> cluster_normals(std::span<const Eigen::Vector3d> normals, std::size_t clusters,
                                           int iterations);

}  // namespace vantage
