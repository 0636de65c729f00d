#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// The octree over a package's point cloud; its points are the blocks of PNTS.
struct PointCloud {
    std::vector<package::PointNode> nodes;  ///< the root first
    std::uint32_t blocks = 0;
    std::uint64_t points = 0;
};

/// The bit of SceneRecord::effects that marks a scene of points only. Its mesh is a stand-in
/// (pipeline/mesh/stand_in.h) by which photos and tiles are chosen, and is never shown.
inline constexpr std::uint64_t points_only_bit = std::uint64_t(1) << 63;
inline bool points_only(const package::SceneRecord& scene) { return scene.effects & points_only_bit; }

/// Copied, because the file may be overwritten while it is shown; nothing if the effect is off. Throws
/// Error(damaged) if nodes and points do not fit together.
std::optional<PointCloud> read_point_cloud(const PackageReader& package);

/// A position in a node's cube as stored, and back: off by at most size / 2^22 along each axis and the
/// rounding of single precision. Positions outside the cube are moved onto its faces.
package::PackedPoint packed(const Eigen::Vector3d& position, const package::PointNode& node);
Eigen::Vector3d unpacked(const package::PackedPoint& point, const package::PointNode& node);

/// Per node, how far points are apart where no child divides it further: its own spacing, but no more than
/// that of its ancestors, because leaves with few points of their own still have the ancestors' around them.
std::vector<float> local_spacings(const std::vector<package::PointNode>& nodes);

/// The node farthest down the tree from `node` in whose cube a point of `node` is.
std::uint32_t finest_node(const std::vector<package::PointNode>& nodes, std::uint32_t node,
                          const package::PackedPoint& point);

}  // namespace vantage
