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
    Eigen::Vector3d normal;  ///< unit length; downward for a ground
    double height;
};

/// The inverse distance from a center at which a direction meets the plane; 0 if it does not.
inline float inverse_distance(const Plane& plane, const Eigen::Vector3d& center,
                              const Eigen::Vector3f& direction) {
    const double w = plane.normal.dot(direction.cast<double>()) / (plane.height - plane.normal.dot(center));
    return std::isfinite(w) ? float(std::max(w, 0.0)) : 0;
}

/// What a mesh tells about the planes on which its background lie.
struct MeshPlanes {
    std::vector<Plane> largest;           ///< at most three, each with a twenty-fifth of the surface
    std::optional<Eigen::Vector3d> down;  ///< unit length; nothing if the mesh has too few walls and floors
    std::optional<Plane> floor;           ///< the largest below all cameras
};
/// By RANSAC (Fischler and Bolles 1981); with `down`, the floor is level. Deterministic.
MeshPlanes mesh_planes(std::span<const SurfaceDisc> discs, std::span<const CoarseView> views);

/// How far down the lowest camera is; -inf without views.
double lowest_camera(std::span<const CoarseView> views, const Eigen::Vector3d& down);

/// What is down according to the photos, and according to the mesh or else to them.
Eigen::Vector3d down_direction(std::span<const CoarseView> views);
Eigen::Vector3d down_direction(std::span<const CoarseView> views, const MeshPlanes& mesh);

/// The mesh's floor continued, or else the plane below the cameras on which what the mesh leaves open agrees
/// best between photos; nothing if no plane stands out.
std::optional<Plane> find_ground(std::span<const CoarseView> views, const MeshPlanes& mesh);

/// The planes that background may lie on.
struct ScenePlanes {
    std::optional<Plane> ground;
    std::vector<Plane> walls;  ///< of the mesh, or found beyond it
};

}  // namespace vantage
