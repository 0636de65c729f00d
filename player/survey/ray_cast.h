#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>

#include "player/plan/plan_scene.h"
#include "player/view/ray.h"

namespace vantage {

/// The intersection of a ray with the mesh.
struct MeshHit {
    std::uint32_t triangle;  ///< from 0
    double distance;         ///< as a multiple of the ray's direction vector
    Eigen::Vector3d position;
};

/// The tested range of a ray, as multiples of its direction vector.
struct RayRange {
    double nearest = 0, farthest = std::numeric_limits<double>::infinity();
};

/// The first intersection of a ray with the mesh, from either side; includes transparent surfaces, but not
/// the background. It is computed in double precision, independently of rendering (Moeller and Trumbore
/// 1997), using the tree of clusters. Returns nullopt if the ray misses the mesh, is not finite or has no
/// direction.
std::optional<MeshHit> first_hit(const PlanScene& scene, const Ray& ray, RayRange range = {});

}  // namespace vantage
