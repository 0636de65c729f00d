#pragma once
#include <vector>

#include "scene/package/contents/mesh.h"

namespace vantage {

/// The signed distance from each of the mesh's vertices to the nearest point of `reference`, in input units.
/// The distance is positive on the side to which the reference's normals point, and unsigned if the reference
/// is a cloud without normals. Normals of a mesh are those of its triangles, weighted by angle on edges and
/// at corners (Baerentzen and Aanaes 2005). Accurate to single precision. Includes the mesh's strays. Runs on
/// all cores. Throws Error(memory).
std::vector<float> deviation(const Mesh& mesh, const Mesh& reference);

}  // namespace vantage
