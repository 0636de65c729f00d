#pragma once
#include <span>
#include <vector>

#include "pipeline/mesh/nearest_surface.h"
#include "scene/camera/similarity.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Similarities that lead points near a mesh's surface, found without an initial guess: iterated closest
/// points (Besl and McKay 1992) with scale, from rotations all around and several scales, of which the better
/// are kept. To the accuracy of a grid. The nearer `count` ones, the nearest first. Deterministic.
std::vector<Similarity> start_poses(std::span<const Eigen::Vector3d> points, const Mesh& mesh,
                                    const NearestSurface& surface, std::size_t count);

}  // namespace vantage
