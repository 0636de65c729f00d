#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "agreement/surface_discs.h"
#include "pipeline/surroundings/coarse_view.h"

namespace vantage {

/// Points p with normal . p = height, relative to the origin.
struct Plane {
    Eigen::Vector3d normal;  ///< unit length; downward for a ground
    double height;
};

/// The inverse distance from a center at which a direction meets the plane; 0 if it does not.
inline float inverse_distance(const Plane& plane, const Eigen::Vector3d& center,
                              const Eigen::Vector3f& direction) {
    const double w = plane.normal.dot(direction.cast<double>()) / (plane.height - plane.normal.dot(center));
    return std::isfinite(w) ? float(std::max(w, 0.0)) : 0;
}

/// The direction that the photos' rows agree to call down: perpendicular to all of them, as nobody holds a
/// camera askew on purpose. If all rows are parallel, the mean of the columns.
Eigen::Vector3d down_direction(std::span<const CoarseView> views);

/// The plane below the cameras on which what the mesh leaves open agrees best between photos; nothing if no
/// plane stands out.
std::optional<Plane> find_ground(std::span<const CoarseView> views);

/// The planes that surroundings may lie on.
struct ScenePlanes {
    std::optional<Plane> ground;
    std::vector<Plane> of_mesh;  ///< the largest, at most three
};
/// The planes on which at least a twenty-fifth of the mesh's surface lies, the largest first (RANSAC,
/// Fischler and Bolles 1981). Deterministic.
std::vector<Plane> mesh_planes(std::span<const SurfaceDisc> discs);

}  // namespace vantage
