#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/background/coarse_view.h"
#include "scene/agreement/surface_discs.h"

namespace vantage {

/// Points p with normal . p = height, relative to the origin.
struct Plane {
    Eigen::Vector3d normal;  ///< unit length; points down for the ground
    double height;
};

/// The inverse of the distance from a center at which a direction meets the plane; 0 if it does not.
inline float inverse_distance(const Plane& plane, const Eigen::Vector3d& center,
                              const Eigen::Vector3f& direction) {
    const double w = plane.normal.dot(direction.cast<double>()) / (plane.height - plane.normal.dot(center));
    return std::isfinite(w) ? float(std::max(w, 0.0)) : 0;
}

/// The planes of a mesh on which the background may continue.
struct MeshPlanes {
    std::vector<Plane> largest;           ///< at most three, each with at least 4 % of the surface
    std::optional<Eigen::Vector3d> down;  ///< unit length; empty if the mesh has too few walls and floors
    std::optional<Plane> floor;           ///< the largest level plane below all cameras
};
/// Finds planes with RANSAC (Fischler and Bolles 1981). The floor is level if `down` is known. Deterministic.
MeshPlanes mesh_planes(std::span<const SurfaceDisc> discs, std::span<const CoarseView> views);

/// The height of the lowest camera, measured downward; -inf without views.
double lowest_camera(std::span<const CoarseView> views, const Eigen::Vector3d& down);

/// The down direction: from the photos alone, or from the mesh with the photos as a fallback.
Eigen::Vector3d down_direction(std::span<const CoarseView> views);
Eigen::Vector3d down_direction(std::span<const CoarseView> views, const MeshPlanes& mesh);

/// The plane of the mesh's floor or, if the photos' open texels do not agree on it, the plane below the
/// cameras on which they agree best; empty if no plane stands out.
std::optional<Plane> find_ground(std::span<const CoarseView> views, const MeshPlanes& mesh);

/// The planes on which background may lie.
struct ScenePlanes {
    std::optional<Plane> ground;
    std::vector<Plane> walls;  ///< walls of the mesh and walls found beyond it
};

}  // namespace vantage
