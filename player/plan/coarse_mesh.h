#pragma once
#include <cstdint>
#include <stop_token>
#include <vector>

#include "player/plan/plan_scene.h"

namespace vantage {

/// A simplified mesh for frames in motion.
struct CoarseMesh {
    std::vector<std::uint32_t> indices;  ///< three of the scene's vertices per triangle
    std::vector<std::uint32_t>
        stands_for;    ///< per triangle: a triangle of the scene that it replaces, numbered from 0
    double error = 0;  ///< approximate distance from the mesh, scene units
};

/// Maximum number of triangles of a scene's coarse mesh: an eighth of the opaque triangles, or 0 if the mesh
/// is too small to benefit.
std::size_t coarse_triangles(const PlanScene& scene);

/// Simplifies the opaque mesh in parts, with their common borders unchanged (quadric error metrics: Garland
/// and Heckbert 1997). Empty if there is nothing to simplify or if the thread is asked to stop.
CoarseMesh make_coarse_mesh(const PlanScene& scene, const std::stop_token& stop);

}  // namespace vantage
