#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/package_reader.h"

namespace vantage {

/// The octree over a package's point cloud; its points are the blocks of PNTS.
struct PointCloud {
    std::vector<package::PointNode> nodes;  ///< the root first
    std::uint32_t blocks = 0;
    std::uint64_t points = 0;
};

/// Copied, because the file may be overwritten while it is shown; nothing if the effect is off. Throws
/// Error(damaged) if nodes and points do not fit together.
std::optional<PointCloud> read_point_cloud(const PackageReader& package);

/// A position in a node's cube as stored, and back: off by at most size / 2^22 along each axis and the
/// rounding of single precision. Positions outside the cube are moved onto its faces.
package::PackedPoint packed(const Eigen::Vector3d& position, const package::PointNode& node);
Eigen::Vector3d unpacked(const package::PackedPoint& point, const package::PointNode& node);

}  // namespace vantage
