#include "player/render/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "base/text/error.h"
#include "scene/package/contents/background.h"
#include "shaders/contract.h"

namespace vantage {

using package::Type;

namespace {

/// The mesh's normals as stored, then the color corrections of the background, which has no normals.
std::vector<Eigen::Vector3f> normals_of(const PackageReader& package, const PlanScene& scene) {
    const auto stored = package.records<Eigen::Vector3f>(Type::normals);
    std::vector<Eigen::Vector3f> out(stored.begin(), stored.end());
    for (const auto& c : scene.surrounding_corrections)
        out.push_back(Eigen::Vector3f(c[0], c[1], c[2]) / correction_scale);
    package.forget(std::as_bytes(stored));
    return out;
}

/// sRGB and alpha, one per vertex. A mesh without colors is white.
std::vector<std::array<std::uint8_t, 4>> colors_of(const PackageReader& package, const PlanScene& scene) {
    using Color = std::array<std::uint8_t, 4>;
    std::vector<Color> out(package.scene().vertices, Color{255, 255, 255, 255});
    if (effect_on(package.scene(), Effect::vertex_colors) ||
        effect_on(package.scene(), Effect::transparency)) {
        const auto stored = package.records<Color>(Type::colors);
        if (stored.size() != out.size())
            throw Error(Exit::damaged,
                        package.path().string() + ": VCOL: the length does not match the scene's counts");
        out.assign(stored.begin(), stored.end());
    }
    out.insert(out.end(), scene.surrounding_colors.begin(), scene.surrounding_colors.end());
    return out;
}

/// Whether blending programs can read all of the model.
bool can_be_read(const Model& m, const PlanScene& scene) {
    GLint bindings = 0, blocks = 0;
    GLint64 most = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    const std::size_t largest =
        std::max((scene.indices.size() + 3 * m.coarse_capacity) * 4, scene.positions.size() * 12);
    return m.indices && bindings > shader::cluster_photos_buffer && blocks >= shader::blend_buffers &&
           largest <= std::size_t(most);
}

/// The cluster of each triangle of the model.
std::vector<std::uint32_t> clusters_of_all(const PlanScene& scene) {
    std::vector<std::uint32_t> triangles(scene.triangles);
    std::iota(triangles.begin(), triangles.end(), 1u);
    return clusters_of(scene, triangles);
}

/// A value, and 1 if it is valid or 0 if not.
using Value = std::array<float, 2>;

template <class T>
gl::Buffer buffer_of(const char* name, std::span<const T> values) {
    return gl::make_buffer(name, values.size_bytes(), values.data());
}

/// A buffer that can be written to, with space for `more` values at the end.
gl::Buffer buffer_of(const char* name, std::span<const std::uint32_t> values, std::size_t more) {
    gl::Buffer out =
        gl::make_buffer(name, values.size_bytes() + more * sizeof values[0], nullptr, GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferSubData(out.id(), 0, GLsizeiptr(values.size_bytes()), values.data());
    return out;
}

template <class T>
void write_behind(const gl::Buffer& buffer, std::size_t values, const std::vector<T>& more) {
    glNamedBufferSubData(buffer.id(), GLintptr(values * sizeof(T)), GLsizeiptr(more.size() * sizeof(T)),
                         more.data());
}

}  // namespace

Model load_model(const PackageReader& package, const PlanScene& scene) {
    using shader::color_attribute, shader::draw_attribute;
    if (scene.indices.size() > std::size_t(std::numeric_limits<GLsizei>::max()))
        throw Error(Exit::damaged, package.path().string() + ": INDX has more triangles than can be drawn");
    Model m;
    m.vertex_count = std::uint32_t(package.scene().vertices);
    m.positions = buffer_of("positions", scene.positions);
    if (scene.has_background()) {
        m.normals = buffer_of("normals", std::span<const Eigen::Vector3f>(normals_of(package, scene)));
    } else {
        const auto normals = package.records<float>(Type::normals);
        m.normals = buffer_of("normals", normals);
        package.forget(std::as_bytes(normals));
    }
    m.coarse_capacity = coarse_triangles(scene);
    m.indices = buffer_of("indices", scene.indices, 3 * m.coarse_capacity);
    if (can_be_read(m, scene))
        m.triangle_clusters = buffer_of("triangles' clusters", clusters_of_all(scene), m.coarse_capacity);
    m.vertices = gl::make_vertex_array("model");
    gl::attach_floats(m.vertices, shader::position_attribute, m.positions, 3, 12);
    gl::attach_floats(m.vertices, shader::normal_attribute, m.normals, 3, 12);
    glVertexArrayElementBuffer(m.vertices.id(), m.indices.id());
    for (const Type type : {Type::positions, Type::indices}) package.forget(package.records<std::byte>(type));
    glVertexArrayAttribIFormat(m.vertices.id(), draw_attribute, 2, GL_UNSIGNED_INT, 0);
    glVertexArrayAttribBinding(m.vertices.id(), draw_attribute, draw_attribute);
    glVertexArrayBindingDivisor(m.vertices.id(), draw_attribute, 2);  // the same for both eyes
    glEnableVertexArrayAttrib(m.vertices.id(), draw_attribute);
    if (!effect_on(package.scene(), Effect::vertex_colors) &&
        !effect_on(package.scene(), Effect::transparency) && !scene.has_background())
        return m;
    const auto colors = colors_of(package, scene);
    m.colors =
        gl::make_buffer("colors", colors.size() * sizeof colors[0], colors.data(), GL_DYNAMIC_STORAGE_BIT);
    glVertexArrayVertexBuffer(m.vertices.id(), color_attribute, m.colors.id(), 0, 4);
    glVertexArrayAttribFormat(m.vertices.id(), color_attribute, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
    glVertexArrayAttribBinding(m.vertices.id(), color_attribute, color_attribute);
    glEnableVertexArrayAttrib(m.vertices.id(), color_attribute);
    return m;
}

void write_hidden(Model& model, const PlanScene& scene) {
    glNamedBufferSubData(model.indices.id(), 0, GLsizeiptr(scene.indices.size_bytes()), scene.indices.data());
    if (scene.has_background()) write_behind(model.colors, model.vertex_count, scene.surrounding_colors);
}

bool add_coarse_mesh(Model& model, const PlanScene& scene, const CoarseMesh& mesh) {
    if (!model.triangle_clusters || mesh.stands_for.size() > model.coarse_capacity) return false;
    std::vector<std::uint32_t> clusters = mesh.stands_for;
    for (std::uint32_t& number : clusters) ++number;  // from 1
    clusters = clusters_of(scene, clusters);
    write_behind(model.indices, scene.indices.size(), mesh.indices);
    write_behind(model.triangle_clusters, scene.triangles, clusters);
    return true;
}

void show_values(Model& model, const PlanScene& scene, std::span<const float> values) {
    std::vector<Value> all(scene.positions.size(), Value{0, 0});
    for (std::size_t v = 0; v < std::min(values.size(), all.size()); ++v)
        if (std::isfinite(values[v])) all[v] = {values[v], 1};
    const std::size_t bytes = all.size() * sizeof(Value);
    if (model.values) {
        glNamedBufferSubData(model.values.id(), 0, GLsizeiptr(bytes), all.data());
        return;
    }
    model.values = gl::make_buffer("values", bytes, all.data(), GL_DYNAMIC_STORAGE_BIT);
    gl::attach_floats(model.vertices, shader::value_attribute, model.values, 2, sizeof(Value));
}

}  // namespace vantage
