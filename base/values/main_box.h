#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {

/// The bounding box of a mesh's vertices, excluding strays, which lie far from all other vertices.
struct MainBox {
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = low;
    std::vector<std::uint32_t> strays;  ///< the vertices outside the box, in ascending order

    double diagonal() const;
    double distance(const Eigen::Vector3d& p) const;
};

/// At most 1 % of the vertices are strays (or 3, if that is more, but never more than a quarter). A stray is
/// more than 20 times as far from the median of the coordinates as any vertex that is not a stray. Only
/// vertices of triangles count, or all vertices if there are no triangles. If there are no strays, the box
/// contains all vertices. Positions must be finite. The box is zero if there are no vertices.
MainBox main_box(std::span<const Eigen::Vector3d> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles);
/// The box of a mesh. Computing the box takes a moment, so callers do it once and pass the box on.
MainBox main_box(const auto& mesh) { return main_box(mesh.positions, mesh.triangles); }

/// Whether a corner of the triangle is a stray, that is, whether its distance from `bounds`, the box without
/// strays, exceeds the box's diagonal. False if `bounds` is empty.
bool has_stray(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::AlignedBox3d& bounds);

}  // namespace vantage
