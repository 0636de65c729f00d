#pragma once
#include <cstdint>
#include <stop_token>
#include <vector>

#include "player/plan/plan_scene.h"

namespace vantage {

/// Fewer triangles in place of those of the mesh, for frames in motion.
struct CoarseMesh {
    std::vector<std::uint32_t> indices;  ///< three of the scene's vertices per triangle
    std::vector<std::uint32_t>
        stands_for;    ///< per triangle: one of the scene, numbered from 0, that it replaces
    double error = 0;  ///< about its distance from the mesh, scene units
};

/// How many triangles a scene's coarse mesh has, at most: an eighth of the opaque ones; 0: they are too few
/// for it to be of use.
std::size_t coarse_triangles(const PlanScene& scene);

/// Simplifies the opaque mesh in parts, whose common borders stay as they are (quadric error metrics: Garland
/// and Heckbert 1997). Empty if there is nothing to simplify, or the thread is asked to stop.
CoarseMesh make_coarse_mesh(const PlanScene& scene, const std::stop_token& stop);

}  // namespace vantage
