#pragma once
#include <Eigen/Core>
#include <vector>

#include "pipeline/mesh/point_tree.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A cloud's points as a package stores them, relative to its origin, and half the distance to their
/// neighbors: of the finest node of the octree in which each is.
struct SplatCloud {
    std::vector<Eigen::Vector3f> positions;
    std::vector<float> radii;
};

/// Of the cloud from which the tree was made.
SplatCloud splat_cloud(const PointTree& tree, const Mesh& cloud, const Eigen::Vector3d& origin);
/// The same, from a package with the effect `points`. Throws Error(damaged).
SplatCloud splat_cloud(const PackageReader& package);

}  // namespace vantage
