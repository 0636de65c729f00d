#pragma once
#include <span>
#include <vector>

#include "pipeline/mesh/nearest_surface.h"
#include "scene/camera/similarity.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Similarities that move points close to a mesh's surface, found without an initial guess: iterated closest
/// points (Besl and McKay 1992) with scale, started from evenly spread rotations and several scales. Accurate
/// to a grid cell. Returns the best `count` of them, best first. Deterministic.
std::vector<Similarity> start_poses(std::span<const Eigen::Vector3d> points, const Mesh& mesh,
                                    const NearestSurface& surface, std::size_t count);

}  // namespace vantage
