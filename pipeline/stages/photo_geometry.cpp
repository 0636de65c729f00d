#include "pipeline/stages/photo_geometry.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <tuple>

#include "gl/context.h"
#include "gl/program.h"
#include "scene/tiling.h"

namespace vantage {
namespace {

struct Matrices {
    Eigen::Matrix4f cam_from_origin, clip_from_origin;
};

Matrices matrices(const Intrinsics& k, const Pose& pose, Eigen::Vector2d near_far) {
    Eigen::Matrix4d cam = Eigen::Matrix4d::Identity();
    cam.topLeftCorner<3, 3>() = pose.R;
    cam.topRightCorner<3, 1>() = pose.t;
    const Eigen::Matrix4d clip = clip_from_cam(k, near_far.x(), near_far.y()) * cam;
    return {cam.cast<float>(), clip.cast<float>()};
}

void draw(const ModelBuffers& model, const gl::Framebuffer& target, int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDisable(GL_CULL_FACE);
    glBindVertexArray(model.vertices.id());
    glDrawElements(GL_TRIANGLES, GLsizei(model.index_count), GL_UNSIGNED_INT, nullptr);
}

/// The triangle that each pixel of the photo sees, 2^32 - 1 beside the model.
gl::Texture render_triangles(const ModelBuffers& model, const Intrinsics& k, const Matrices& m) {
    const gl::Texture depth = gl::make_texture_2d("photo depth", GL_DEPTH_COMPONENT32F, k.width, k.height);
    gl::Texture triangles = gl::make_texture_2d("photo triangles", GL_R32UI, k.width, k.height);
    const gl::Framebuffer target =
        gl::make_framebuffer("photo triangles", std::array{triangles.id()}, depth.id());
    const float one = 1;
    const std::array<GLuint, 4> nothing{~0u, 0, 0, 0};
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &one);
    glClearNamedFramebufferuiv(target.id(), GL_COLOR, 0, nothing.data());
    glUseProgram(model.triangle_id.id());
    glUniformMatrix4fv(0, 1, GL_FALSE, m.clip_from_origin.data());
    draw(model, target, k.width, k.height);
    return triangles;
}

void render_maps(const ModelBuffers& model, const Matrices& m, PhotoGeometry& out) {
    const gl::Texture z = gl::make_texture_2d("linear depth", GL_R32F, out.width, out.height);
    const gl::Texture angle = gl::make_texture_2d("angle mask", GL_R8, out.width, out.height);
    const gl::Texture depth = gl::make_texture_2d("depth", GL_DEPTH_COMPONENT32F, out.width, out.height);
    const std::array colors{z.id(), angle.id()};
    const gl::Framebuffer target = gl::make_framebuffer("photo geometry", colors, depth.id());
    const float one = 1;
    const std::array nothing{std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 0.0f};
    const std::array<float, 4> zero{};
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &one);
    glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, nothing.data());
    glClearNamedFramebufferfv(target.id(), GL_COLOR, 1, zero.data());
    glUseProgram(model.geometry.id());
    glUniformMatrix4fv(0, 1, GL_FALSE, m.clip_from_origin.data());
    glUniformMatrix4fv(1, 1, GL_FALSE, m.cam_from_origin.data());
    draw(model, target, out.width, out.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(z.id(), 0, GL_RED, GL_FLOAT, GLsizei(out.z.size() * sizeof(float)), out.z.data());
    glGetTextureImage(angle.id(), 0, GL_RED, GL_UNSIGNED_BYTE, GLsizei(out.angle.size()), out.angle.data());
}

/// Runs `program` on `count` vertices (all in order, or those of the bound element buffer) and takes its
/// coordinates.
std::vector<Eigen::Vector2f> capture(const gl::Program& program, std::size_t count, bool indexed) {
    std::vector<Eigen::Vector2f> out(count);
    const std::size_t bytes = count * sizeof(Eigen::Vector2f);
    const gl::Buffer captured = gl::make_buffer("texture coordinates", bytes, nullptr, 0);
    glUseProgram(program.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.id());
    glBeginTransformFeedback(GL_POINTS);
    if (indexed)
        glDrawElements(GL_POINTS, GLsizei(count), GL_UNSIGNED_INT, nullptr);
    else
        glDrawArrays(GL_POINTS, 0, GLsizei(count));
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glGetNamedBufferSubData(captured.id(), 0, GLsizeiptr(bytes), out.data());
    return out;
}

/// The second run, for the vertices that the first could not settle.
void settle(const ModelBuffers& model, std::vector<Eigen::Vector2f>& coordinates) {
    std::vector<std::uint32_t> open;
    for (std::size_t v = 0; v < coordinates.size(); ++v)
        if (coordinates[v].x() < -1.5f) open.push_back(std::uint32_t(v));
    if (open.empty()) return;
    const gl::Buffer elements = gl::make_buffer("unsettled vertices", open.size() * 4, open.data());
    glVertexArrayElementBuffer(model.vertices.id(), elements.id());
    const std::vector<Eigen::Vector2f> settled = capture(model.settle, open.size(), true);
    glVertexArrayElementBuffer(model.vertices.id(), model.indices.id());
    for (std::size_t i = 0; i < open.size(); ++i) coordinates[open[i]] = settled[i];
}

std::vector<Eigen::Vector2f> capture_coordinates(const ModelBuffers& model, const Intrinsics& k,
                                                 const Pose& pose, const Matrices& m,
                                                 const gl::Texture& triangles) {
    // Without a surface every draw needs a framebuffer, even one that rasterises nothing.
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    const gl::Framebuffer nothing(id);
    glNamedFramebufferParameteri(id, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
    glNamedFramebufferParameteri(id, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    const Eigen::Vector3f eye = pose.center().cast<float>();
    for (const gl::Program* program : {&model.coordinates, &model.settle}) {
        glProgramUniformMatrix4fv(program->id(), 0, 1, GL_FALSE, m.cam_from_origin.data());
        glProgramUniform4f(program->id(), 1, float(k.fx), float(k.fy), float(k.cx), float(k.cy));
        glProgramUniform2f(program->id(), 2, float(k.width), float(k.height));
        glProgramUniform3fv(program->id(), 3, 1, eye.data());
    }
    glBindTextureUnit(0, triangles.id());
    const GLuint buffers[] = {model.positions.id(), model.indices.id(), model.incident_ranges.id(),
                              model.incident.id()};
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, 4, buffers);
    glBindVertexArray(model.vertices.id());
    glEnable(GL_RASTERIZER_DISCARD);
    std::vector<Eigen::Vector2f> out = capture(model.coordinates, model.vertex_count, false);
    settle(model, out);
    glDisable(GL_RASTERIZER_DISCARD);
    return out;
}

/// The triangles at each vertex's place, also those of other vertices at the same place: `triangles` from the
/// range's first up to its second.
struct Incidence {
    std::vector<std::array<std::uint32_t, 2>> ranges;
    std::vector<std::uint32_t> triangles;
};

/// The first vertex at each vertex's place.
std::vector<std::uint32_t> find_places(std::span<const Eigen::Vector3f> positions) {
    std::vector<std::uint32_t> order(positions.size()), place(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t v) {
        return std::tuple(positions[v].x(), positions[v].y(), positions[v].z());
    };
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
        place[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? place[order[i - 1]] : order[i];
    return place;
}

Incidence find_incidence(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices) {
    const std::vector<std::uint32_t> place = find_places(positions);
    std::vector<std::uint32_t> first(positions.size() + 1, 0);
    for (const std::uint32_t v : indices) ++first[place[v] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    Incidence out;
    for (const std::uint32_t p : place) out.ranges.push_back({first[p], first[p + 1]});
    out.triangles.resize(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        out.triangles[first[place[indices[i]]]++] = std::uint32_t(i / 3);
    return out;
}

}  // namespace

ModelBuffers upload_model(std::span<const Eigen::Vector3f> positions,
                          std::span<const Eigen::Vector3f> normals, std::span<const std::uint32_t> indices) {
    ModelBuffers m;
    m.positions = gl::make_buffer("positions", positions.size_bytes(), positions.data());
    m.normals = gl::make_buffer("normals", normals.size_bytes(), normals.data());
    m.indices = gl::make_buffer("indices", indices.size_bytes(), indices.data());
    const Incidence incidence = find_incidence(positions, indices);
    m.incident_ranges =
        gl::make_buffer("incident ranges", incidence.ranges.size() * 8, incidence.ranges.data());
    m.incident =
        gl::make_buffer("incident triangles", incidence.triangles.size() * 4, incidence.triangles.data());
    m.vertices = gl::make_vertex_array("model");
    gl::attach_floats(m.vertices, 0, m.positions, 3, 12);
    gl::attach_floats(m.vertices, 1, m.normals, 3, 12);
    glVertexArrayElementBuffer(m.vertices.id(), m.indices.id());
    m.triangle_id = gl::make_program(
        "triangle id", {{GL_VERTEX_SHADER, "triangle_id.vert"}, {GL_FRAGMENT_SHADER, "triangle_id.frag"}});
    m.geometry = gl::make_program("photo geometry", {{GL_VERTEX_SHADER, "photo_geometry.vert"},
                                                     {GL_FRAGMENT_SHADER, "photo_geometry.frag"}});
    m.coordinates = gl::make_program("texture coordinates", {{GL_VERTEX_SHADER, "texture_coordinates.vert"}},
                                     {}, {"coordinate"});
    m.settle = gl::make_program("unsettled coordinates", {{GL_VERTEX_SHADER, "texture_coordinates.vert"}},
                                {"SETTLE"}, {"coordinate"});
    m.vertex_count = positions.size();
    m.index_count = indices.size();
    gl::check("uploading the model");
    return m;
}

Eigen::Vector2d depth_range(std::span<const Eigen::Vector3f> positions, const Pose& pose) {
    const Eigen::Vector3d axis = pose.R.row(2);
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const Eigen::Vector3f& p : positions) {
        const double z = axis.dot(p.cast<double>()) + pose.t.z();
        if (z > 0) nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    if (!(farthest > 0)) return {0, 0};
    return {std::max(nearest * 0.999, farthest * 1e-5), farthest * 1.001};
}

PhotoGeometry render_geometry(const ModelBuffers& model, const Intrinsics& k, const Pose& pose,
                              Eigen::Vector2d near_far) {
    const Level half = level_size(k.width, k.height, mask_level);
    const std::size_t pixels = std::size_t(half.width) * std::size_t(half.height);
    PhotoGeometry out{half.width, half.height,
                      std::vector<float>(pixels, std::numeric_limits<float>::infinity()),
                      std::vector<std::uint8_t>(pixels, 0),
                      std::vector<Eigen::Vector2f>(model.vertex_count, Eigen::Vector2f(-1, -1))};
    if (!(near_far.y() > 0)) return out;
    const Matrices full = matrices(k, pose, near_far);
    // A level's pixel is 2^level pixels wide even where the size is odd, so the frame grows by the rounding.
    const double s = 1.0 / (1 << mask_level);
    const Intrinsics coarse{half.width, half.height, k.fx * s, k.fy * s, k.cx * s, k.cy * s};
    out.coordinates = capture_coordinates(model, k, pose, full, render_triangles(model, k, full));
    render_maps(model, matrices(coarse, pose, near_far), out);
    gl::check("rendering a photo's geometry");
    return out;
}

}  // namespace vantage
