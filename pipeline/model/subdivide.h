#pragma once
#include "scene/mesh.h"

namespace vantage {

/// Halves edges longer than 1/64 of the diagonal of the mesh's box until none is left, so that what is
/// recorded by triangle (which photos see it, how it is culled) means something on room-sized ones, too. The
/// surface stays as it is: an edge is halved for all its triangles or for none, so nothing comes apart.
/// Attributes of new vertices are the means of their ends'. Where that would make more than 2^18 triangles
/// more than there are, longer edges stay. Returns how many triangles there are more.
std::size_t subdivide_large_triangles(Mesh& mesh);

}  // namespace vantage
