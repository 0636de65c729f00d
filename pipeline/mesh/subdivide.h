#pragma once
#include "base/values/main_box.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Halves edges until none is longer than 1/64 of the diagonal of `box`, the mesh's main_box, so that data
/// per triangle (which photos see it, how it is culled) is meaningful for room-sized triangles as well. The
/// surface does not change, and no cracks appear: an edge is halved in all its triangles or in none. Edges of
/// strays are unchanged. New vertices get the mean attributes of the edge's ends. If this would add more than
/// 2^18 triangles, the length limit is doubled until it does not. Returns the number of triangles added.
std::size_t subdivide_large_triangles(Mesh& mesh, const MainBox& box);

}  // namespace vantage
