#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/package/package_reader.h"

namespace vantage {

/// The octree over a package's point cloud; its points are the blocks of PNTS.
struct PointCloud {
    std::vector<package::PointNode> nodes;  ///< root first
    std::uint32_t blocks = 0;
    std::uint64_t points = 0;
};

/// The bit of SceneRecord::effects that marks a point-only scene. The mesh of such a scene is a proxy
/// (pipeline/mesh/stand_in.h) for selecting photos and tiles, and is never shown.
inline constexpr std::uint64_t points_only_bit = std::uint64_t(1) << 63;
inline bool points_only(const package::SceneRecord& scene) { return scene.effects & points_only_bit; }

/// The package's point cloud, copied because the file may be overwritten while it is shown; empty if the
/// effect is off. Throws Error(damaged) if nodes and points are inconsistent.
std::optional<PointCloud> read_point_cloud(const PackageReader& package);

/// These two functions quantize a position in a node's cube and restore it, to within size / 2^22 along each
/// axis, plus rounding in single precision. Positions outside the cube are moved onto its faces.
package::PackedPoint packed(const Eigen::Vector3d& position, const package::PointNode& node);
Eigen::Vector3d unpacked(const package::PackedPoint& point, const package::PointNode& node);

/// For each node, the distance between points in the parts of its cube that no child refines. This distance
/// is the node's own spacing, but at most that of its ancestors, because the ancestors' points fill even
/// leaves that have few points of their own.
std::vector<float> local_spacings(const std::vector<package::PointNode>& nodes);

/// The deepest descendant of `node` whose cube contains `point`, which is a point of `node`.
std::uint32_t finest_node(const std::vector<package::PointNode>& nodes, std::uint32_t node,
                          const package::PackedPoint& point);

}  // namespace vantage
