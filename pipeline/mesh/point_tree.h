#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scene/package/contents/mesh.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// An octree over a cloud with nested levels of detail, and the node of each point. For each cell of a grid
/// over its cube, an inner node takes the point nearest to the cell's center; its children take the other
/// points.
struct PointTree {
    std::vector<package::PointNode> nodes;  ///< level by level, the root first
    std::vector<std::uint32_t> order;       ///< points of the cloud, grouped by node
    std::vector<std::uint64_t> starts;      ///< index into `order` of the first point of each node
    std::uint32_t blocks = 0;

    bool empty() const { return nodes.empty(); }
};

/// `origin` is subtracted from the positions, which must be finite. Deterministic. An empty cloud has an
/// empty tree.
PointTree make_point_tree(const Mesh& cloud, const Eigen::Vector3d& origin);

/// Writes PNOD and PNTS. Points without color are light gray. Throws Error(storage).
void write_points(PackageWriter& writer, const PointTree& tree, const Mesh& cloud,
                  const Eigen::Vector3d& origin);

}  // namespace vantage
