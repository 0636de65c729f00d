#pragma once
#include <Eigen/Core>
#include <span>

#include "base/gl/object.h"
#include "player/plan/coarse_mesh.h"
#include "player/plan/plan_scene.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The package's mesh and the background on the graphics card, with the attributes of shaders/contract.glsl.
/// Colors exist only if vertex colors or transparency are on, or if there is a background. The attribute
/// `draw` is one DrawRecord per draw, selected by base instance from a buffer that each pass binds.
struct Model {
    gl::Buffer positions, normals, colors, indices;
    gl::Buffer triangle_clusters;  ///< cluster of each triangle, if photos can be blended by triangle
    gl::Buffer values;             ///< values of the last scalar field shown, if any
    gl::VertexArray vertices;
    std::uint32_t vertex_count = 0;  ///< of the mesh
    /// Capacity of indices and triangle_clusters for additional triangles after the scene's.
    std::size_t coarse_capacity = 0;
};

/// Sets the attribute `value` to a field's values, one per vertex of the mesh.
void show_values(Model& model, const PlanScene& scene, std::span<const float> values);

/// Writes the scene's triangles and background colors again, see hide().
void write_hidden(Model& model, const PlanScene& scene);

/// Appends a coarse mesh after the scene's triangles. Returns false if the coarse mesh has too many
/// triangles.
bool add_coarse_mesh(Model& model, const PlanScene& scene, const CoarseMesh& mesh);

/// Throws Error(damaged) if a checksum does not match or a triangle has a vertex out of range.
Model load_model(const PackageReader& package, const PlanScene& scene);

/// One draw of glMultiDrawElementsIndirect.
struct DrawCommand {
    std::uint32_t count, instances, first_index, base_vertex, base_instance;
};
struct DrawRecord {
    std::uint32_t first_triangle;
    std::uint32_t photos;  ///< one bit per photo of the pass, and shader::background_bit
};

}  // namespace vantage
