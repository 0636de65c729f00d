#pragma once
#include <Eigen/Core>
#include <vector>

#include "pipeline/mesh/point_tree.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A cloud's points as stored in a package, relative to its origin. A point's radius is half the distance to
/// its neighbors, according to the finest octree node that contains it.
struct SplatCloud {
    std::vector<Eigen::Vector3f> positions;
    std::vector<float> radii;
};

/// Creates a splat cloud from a cloud and the tree that was made from it.
SplatCloud splat_cloud(const PointTree& tree, const Mesh& cloud, const Eigen::Vector3d& origin);
/// Reads a splat cloud from a package with the effect `points`. Throws Error(damaged).
SplatCloud splat_cloud(const PackageReader& package);

}  // namespace vantage
