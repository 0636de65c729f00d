#pragma once
#include <cstdint>
#include <span>

#include "pipeline/formats/meshes/mtl.h"
#include "scene/package/contents/mesh.h"

namespace vantage {

/// Gives each vertex the color and alpha of its triangles' material; if the mesh has colors, only the alpha.
/// A vertex between different materials is split: one vertex per color, all with its normal or, if it has
/// none, with the area-weighted mean of its triangles' normals. `of_triangle` contains an index into
/// `materials` for each triangle; an index out of range leaves the triangle's vertices opaque and white.
/// Corners that refer to no vertex are kept.
void color_by_material(Mesh& mesh, std::span<const std::uint32_t> of_triangle,
                       std::span<const MaterialColor> materials);

}  // namespace vantage
