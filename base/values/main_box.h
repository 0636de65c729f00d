#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// The bounding box of a mesh's vertices without strays, which lie far from all others.
struct MainBox {
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
    std::vector<std::uint32_t> strays;  ///< the vertices outside, ascending

    double diagonal() const;
    double distance(const Eigen::Vector3d& p) const;
};

/// Strays are at most 1 % of the vertices (3 are always permitted, but no more than a quarter) and 20 times
/// as far from the median of each coordinate as any other vertex. Only vertices of triangles count, or all if
/// there are no triangles. Without strays, the box contains all vertices. Positions must be finite. Zero if
/// there are no vertices.
MainBox main_box(std::span<const Eigen::Vector3d> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles);
/// The box of a mesh. Computing it takes a moment, so callers do so once and pass it on.
MainBox main_box(const auto& mesh) { return main_box(mesh.positions, mesh.triangles); }

/// Whether a triangle has a stray: a corner whose distance from `bounds`, the box without strays, exceeds the
/// box's diagonal. False if `bounds` is empty.
bool has_stray(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::AlignedBox3d& bounds);

}  // namespace vantage
