#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// The box of a mesh's vertices, without those that lie far from all others.
struct MainBox {
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
    std::vector<std::uint32_t> strays;  ///< the vertices outside, ascending

    double diagonal() const;
    double distance(const Eigen::Vector3d& p) const;
};

/// Strays are at most 1 % of the vertices (at least 3 may be, but no more than a quarter) and 20 times as far
/// as any other vertex from the median of each coordinate. Only vertices of triangles count, all if there are
/// no triangles; the box is that of all vertices if none is a stray. Positions must be finite. Zero without
/// vertices.
MainBox main_box(std::span<const Eigen::Vector3d> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles);
/// Of a mesh. It takes a moment: what needs the box of a scene is given it.
MainBox main_box(const auto& mesh) { return main_box(mesh.positions, mesh.triangles); }

/// Whether a triangle has a stray: a corner farther from `bounds`, the box without strays, than its diagonal.
/// False if `bounds` is empty.
bool has_stray(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::AlignedBox3d& bounds);

}  // namespace vantage
