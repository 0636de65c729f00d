#include "player/render/model.h"

#include <limits>

#include "scene/error.h"
#include "shaders/contract.h"

namespace vantage {

using package::Type;

Model load_model(const PackageReader& package) {
    using shader::color_attribute, shader::draw_attribute;
    const package::SceneRecord& scene = package.scene();
    const auto positions = package.records<float>(Type::positions),
               normals = package.records<float>(Type::normals);
    const auto indices = package.records<std::uint32_t>(Type::indices);
    if (indices.size() > std::size_t(std::numeric_limits<GLsizei>::max()))
        throw Error(Exit::damaged, package.path().string() + ": INDX has more triangles than can be drawn");
    Model m;
    m.vertex_count = std::uint32_t(scene.vertices);
    m.positions = gl::make_buffer("positions", positions.size_bytes(), positions.data());
    m.normals = gl::make_buffer("normals", normals.size_bytes(), normals.data());
    m.indices = gl::make_buffer("indices", indices.size_bytes(), indices.data());
    m.vertices = gl::make_vertex_array("model");
    gl::attach_floats(m.vertices, shader::position_attribute, m.positions, 3, 12);
    gl::attach_floats(m.vertices, shader::normal_attribute, m.normals, 3, 12);
    glVertexArrayElementBuffer(m.vertices.id(), m.indices.id());
    for (const auto chunk : {std::as_bytes(positions), std::as_bytes(normals), std::as_bytes(indices)})
        package.forget(chunk);
    glVertexArrayAttribIFormat(m.vertices.id(), draw_attribute, 2, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(m.vertices.id(), draw_attribute, draw_attribute);
    glVertexArrayBindingDivisor(m.vertices.id(), draw_attribute, 1);
    glEnableVertexArrayAttrib(m.vertices.id(), draw_attribute);
    if (!effect_on(scene, Effect::vertex_colors)) return m;
    const auto colors = package.records<std::uint32_t>(Type::colors);
    if (colors.size() != scene.vertices)
        throw Error(Exit::damaged,
                    package.path().string() + ": VCOL: length does not fit the scene's counts");
    m.colors = gl::make_buffer("colors", colors.size_bytes(), colors.data());
    glVertexArrayVertexBuffer(m.vertices.id(), color_attribute, m.colors.id(), 0, 4);
    glVertexArrayAttribFormat(m.vertices.id(), color_attribute, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
    glVertexArrayAttribBinding(m.vertices.id(), color_attribute, color_attribute);
    glEnableVertexArrayAttrib(m.vertices.id(), color_attribute);
    return m;
}

}  // namespace vantage
