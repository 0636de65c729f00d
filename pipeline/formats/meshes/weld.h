#pragma once
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Merges vertices that are equal in position, normal and color, which formats store once per triangle
/// corner, or once per side of a seam of the texture. Their order stays that of the first ones. Triangles
/// left with less than three vertices are removed. Positions must be finite; scalar fields are not kept.
void weld(Mesh& mesh);

}  // namespace vantage
