#pragma once
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Merges vertices with equal position, normal and color, which formats store once per triangle corner, or
/// once per side of a texture seam. The order of first occurrences is kept. Triangles with fewer than three
/// distinct vertices are removed. Positions must be finite; scalar fields are not kept.
void weld(Mesh& mesh);

}  // namespace vantage
