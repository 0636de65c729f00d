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

/// Spherical k-means (Dhillon and Modha 2001): at most `clusters` directions for unit `normals`, the one with
/// the most members first. Starts from normals far apart and ends after `iterations`; empty clusters and
/// normals that are no numbers are left out.
std::vector<NormalCluster> cluster_normals(std::span<const Eigen::Vector3d> normals, std::size_t clusters,
                                           int iterations);

}  // namespace vantage
