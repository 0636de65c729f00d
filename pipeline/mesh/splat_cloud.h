#pragma once
#include <Eigen/Core>
#include <vector>

#include "pipeline/mesh/point_tree.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A cloud's points as stored in a package, relative to its origin, and half the distance to their neighbors,
/// from the finest octree node that contains each.
struct SplatCloud {
    std::vector<Eigen::Vector3f> positions;
    std::vector<float> radii;
};

/// Creates it from the cloud and the tree made from that cloud.
SplatCloud splat_cloud(const PointTree& tree, const Mesh& cloud, const Eigen::Vector3d& origin);
/// Reads it from a package with the effect `points`. Throws Error(damaged).
SplatCloud splat_cloud(const PackageReader& package);

}  // namespace vantage
