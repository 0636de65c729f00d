#pragma once
#include <Eigen/Core>

#include "gl/object.h"
#include "scene/package_reader.h"

namespace vantage {

/// The package's mesh on the graphics card, with the attributes of shaders/contract.glsl. Colors are present
/// only if the effect is on. The attribute `draw` is one DrawRecord per draw, selected by base instance from
/// a buffer that each pass binds.
struct Model {
    gl::Buffer positions, normals, colors, indices;
    gl::VertexArray vertices;
    std::uint32_t vertex_count = 0;
};

/// Throws Error(damaged) for a checksum mismatch or a triangle with a vertex out of range.
Model load_model(const PackageReader& package);

/// One draw of glMultiDrawElementsIndirect.
struct DrawCommand {
    std::uint32_t count, instances, first_index, base_vertex, base_instance;
};
struct DrawRecord {
    std::uint32_t first_triangle;
    std::uint32_t photos;  ///< one bit per photo of the pass
};

}  // namespace vantage
