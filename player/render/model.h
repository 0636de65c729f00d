#pragma once
#include <Eigen/Core>

#include "gl/object.h"
#include "scene/package_reader.h"

namespace vantage {

/// The package's mesh on the graphics card: attribute 0 position, 1 normal, 2 colour (where the effect is
/// on), 3 a DrawRecord a draw, by its base instance, from a buffer that each pass binds.
struct Model {
    gl::Buffer positions, normals, colors, indices;
    gl::VertexArray vertices;
    std::uint32_t vertex_count = 0;
};

/// Throws Error(damaged) when a checksum is wrong or a triangle names a vertex that does not exist.
Model load_model(const PackageReader& package);

/// A draw of glMultiDrawElementsIndirect.
struct DrawCommand {
    std::uint32_t count, instances, first_index, base_vertex, base_instance;
};
struct DrawRecord {
    std::uint32_t first_triangle;
    std::uint32_t photos;  ///< a bit a photo of the pass
};

}  // namespace vantage
