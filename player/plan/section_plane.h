#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>

namespace vantage {

/// Cuts the model: what is on the side to which the plane's normal points is not shown. The point p is on the
/// plane if normal . p = offset, relative to the package's origin.
struct SectionPlane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length 1
    double offset = 0;

    /// How far in front of the plane a point is, on the side that is cut away.
    double before(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
    bool operator==(const SectionPlane& o) const { return normal == o.normal && offset == o.offset; }
};

/// How many planes can cut the model: those of a box.
inline constexpr std::size_t max_sections = 6;

/// Whether a point is before one of the planes.
inline bool is_cut_away(std::span<const SectionPlane> planes, const Eigen::Vector3d& p) {
    return std::ranges::any_of(planes, [&](const SectionPlane& plane) { return plane.before(p) > 0; });
}

/// The same plane in the coordinates of what is placed in the scene: its point p is at scale * R * p + t.
inline SectionPlane plane_in(const SectionPlane& plane, const Eigen::Matrix3d& R, const Eigen::Vector3d& t,
                             double scale) {
    return {R.transpose() * plane.normal, -plane.before(t) / scale};
}

}  // namespace vantage
