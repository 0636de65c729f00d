#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>

namespace vantage {

/// Cuts the model: the part on the side to which the plane's normal points is hidden. The point p is on the
/// plane if normal . p = offset, relative to the package's origin.
struct SectionPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1
    double offset = 0;

    /// Signed distance of a point from the plane, positive on the removed side.
    double before(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
    bool operator==(const SectionPlane& o) const { return normal == o.normal && offset == o.offset; }
};

/// Maximum number of planes that can cut the model: those of a box.
inline constexpr std::size_t max_sections = 6;

/// Whether a point is on the removed side of any plane.
inline bool is_cut_away(std::span<const SectionPlane> planes, const Eigen::Vector3d& p) {
    return std::ranges::any_of(planes, [&](const SectionPlane& plane) { return plane.before(p) > 0; });
}

/// The plane in the coordinates of an object whose point p is at scale * R * p + t in the scene.
inline SectionPlane plane_in(const SectionPlane& plane, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
                             double scale) {
    return {R.transpose() * plane.normal, -plane.before(t) / scale};
}

}  // namespace vantage
