#pragma once
#include <span>
#include <vector>

#include "pipeline/mesh/nearest_surface.h"
#include "scene/camera/similarity.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Similarities that move points close to a mesh's surface, found without an initial guess: by iterative
/// closest points (Besl and McKay 1992) with scale, starting from evenly spread rotations and several scales.
/// The similarities are accurate to a grid cell. Returns the `count` best, best first. Deterministic.
std::vector<Similarity> start_poses(std::span<const Eigen::Vector3d> points, const Mesh& mesh,
                                    const NearestSurface& surface, std::size_t count);

}  // namespace vantage
