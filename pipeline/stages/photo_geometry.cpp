#include "pipeline/stages/photo_geometry.h"

#include <algorithm>
#include <array>
#include <limits>

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

/// Window depth at the photo's full size, for the vertices' depth test.
gl::Texture render_depth(const ModelBuffers& model, const Intrinsics& k, const Matrices& m) {
    gl::Texture depth = gl::make_texture_2d("photo depth", GL_DEPTH_COMPONENT32F, k.width, k.height);
    const gl::Framebuffer target = gl::make_framebuffer("photo depth", {}, depth.id());
    const float one = 1;
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &one);
    glUseProgram(model.depth_only.id());
    glUniformMatrix4fv(0, 1, GL_FALSE, m.clip_from_origin.data());
    draw(model, target, k.width, k.height);
    return depth;
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

void capture_coordinates(const ModelBuffers& model, const Intrinsics& k, const Matrices& m,
                         Eigen::Vector2d near_far, const gl::Texture& depth,
                         std::vector<Eigen::Vector2f>& out) {
    const std::size_t bytes = out.size() * sizeof(Eigen::Vector2f);
    const gl::Buffer captured = gl::make_buffer("texture coordinates", bytes, nullptr, 0);
    // Without a surface every draw needs a framebuffer, even one that rasterises nothing.
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    const gl::Framebuffer nothing(id);
    glNamedFramebufferParameteri(id, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
    glNamedFramebufferParameteri(id, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    glUseProgram(model.coordinates.id());
    glUniformMatrix4fv(0, 1, GL_FALSE, m.cam_from_origin.data());
    glUniform4f(1, float(k.fx), float(k.fy), float(k.cx), float(k.cy));
    glUniform2f(2, float(k.width), float(k.height));
    glUniform2f(3, float(near_far.x()), float(near_far.y()));
    glBindTextureUnit(0, depth.id());
    glBindVertexArray(model.vertices.id());
    glEnable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.id());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, GLsizei(model.vertex_count));
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glGetNamedBufferSubData(captured.id(), 0, GLsizeiptr(bytes), out.data());
}

}  // namespace

ModelBuffers upload_model(std::span<const Eigen::Vector3f> positions,
                          std::span<const Eigen::Vector3f> normals, std::span<const std::uint32_t> indices) {
    ModelBuffers m;
    m.positions = gl::make_buffer("positions", positions.size_bytes(), positions.data());
    m.normals = gl::make_buffer("normals", normals.size_bytes(), normals.data());
    m.indices = gl::make_buffer("indices", indices.size_bytes(), indices.data());
    m.vertices = gl::make_vertex_array("model");
    gl::attach_floats(m.vertices, 0, m.positions, 3, 12);
    gl::attach_floats(m.vertices, 1, m.normals, 3, 12);
    glVertexArrayElementBuffer(m.vertices.id(), m.indices.id());
    m.depth_only = gl::make_program(
        "depth only", {{GL_VERTEX_SHADER, "depth_only.vert"}, {GL_FRAGMENT_SHADER, "depth_only.frag"}});
    m.geometry = gl::make_program("photo geometry", {{GL_VERTEX_SHADER, "photo_geometry.vert"},
                                                     {GL_FRAGMENT_SHADER, "photo_geometry.frag"}});
    m.coordinates = gl::make_program("texture coordinates", {{GL_VERTEX_SHADER, "texture_coordinates.vert"}},
                                     {}, {"coordinate"});
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
    const gl::Texture depth = render_depth(model, k, full);
    capture_coordinates(model, k, full, near_far, depth, out.coordinates);
    render_maps(model, matrices(coarse, pose, near_far), out);
    gl::check("rendering a photo's geometry");
    return out;
}

}  // namespace vantage
