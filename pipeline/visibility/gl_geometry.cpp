#include "pipeline/visibility/gl_geometry.h"

#include <array>
#include <limits>

#include "base/gl/context.h"
#include "base/gl/program.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

Eigen::Matrix4d cam_from_origin(const Pose& pose) {
    Eigen::Matrix4d cam = Eigen::Matrix4d::Identity();
    cam.topLeftCorner<3, 3>() = pose.R;
    cam.topRightCorner<3, 1>() = pose.t;
    return cam;
}

struct Triangles {
    gl::Buffer indices;
    std::size_t count;  ///< of indices
};

void draw(const ModelBuffers& model, const Triangles& triangles, const gl::Framebuffer& target, int width,
          int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDepthFunc(GL_GREATER);
    glDisable(GL_CULL_FACE);
    glVertexArrayElementBuffer(model.vertices.id(), triangles.indices.id());
    glBindVertexArray(model.vertices.id());
    glDrawElements(GL_TRIANGLES, GLsizei(triangles.count), GL_UNSIGNED_INT, nullptr);
}

void render_maps(const ModelBuffers& model, const Triangles& triangles, const Intrinsics& k, const Pose& pose,
                 Eigen::Vector2d near_far, PhotoGeometry& out) {
    const gl::Texture z = gl::make_texture_2d("linear depth", GL_R32F, out.width, out.height),
                      angle = gl::make_texture_2d("angle weight", GL_R8, out.width, out.height),
                      triangle = gl::make_texture_2d("triangles", GL_R32UI, out.width, out.height),
                      depth = gl::make_texture_2d("depth", GL_DEPTH_COMPONENT32F, out.width, out.height);
    static_assert(shader::linear_z_output == 0 && shader::angle_output == 1 && shader::triangle_output == 2);
    const std::array colors{z.id(), angle.id(), triangle.id()};  // by output
    const gl::Framebuffer target = gl::make_framebuffer("photo geometry", colors, depth.id());
    const float farthest = 0;  // depth is reversed
    const std::array unseen{std::numeric_limits<float>::infinity(), 0.0f, 0.0f, 0.0f};
    const std::array<float, 4> zero{};
    const std::array<GLuint, 4> no_triangle{~0u, 0, 0, 0};
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
    glClearNamedFramebufferfv(target.id(), GL_COLOR, shader::linear_z_output, unseen.data());
    glClearNamedFramebufferfv(target.id(), GL_COLOR, shader::angle_output, zero.data());
    glClearNamedFramebufferuiv(target.id(), GL_COLOR, shader::triangle_output, no_triangle.data());
    glUseProgram(model.geometry.id());
    const Eigen::Matrix4f clip =
        (clip_from_cam(k, near_far.x(), near_far.y()) * cam_from_origin(pose)).cast<float>();
    glUniformMatrix4fv(shader::clip_from_model_uniform, 1, GL_FALSE, clip.data());
    const Eigen::Matrix3f R = pose.R.cast<float>();
    glUniformMatrix3fv(shader::cam_from_world_uniform, 1, GL_FALSE, R.data());
    glUniform4f(shader::focal_center_uniform, float(k.fx), float(k.fy), float(k.cx), float(k.cy));
    draw(model, triangles, target, out.width, out.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(z.id(), 0, GL_RED, GL_FLOAT, GLsizei(out.z.size() * sizeof(float)), out.z.data());
    glGetTextureImage(angle.id(), 0, GL_RED, GL_UNSIGNED_BYTE, GLsizei(out.angle.size()), out.angle.data());
    glGetTextureImage(triangle.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      GLsizei(out.triangles.size() * sizeof(GLuint)), out.triangles.data());
}

}  // namespace

ModelBuffers upload_model(std::span<const Eigen::Vector3f> positions,
                          std::span<const Eigen::Vector3f> normals) {
    ModelBuffers m;
    m.positions = gl::make_buffer("positions", positions.size_bytes(), positions.data());
    m.normals = gl::make_buffer("normals", normals.size_bytes(), normals.data());
    m.vertices = gl::make_vertex_array("model");
    gl::attach_floats(m.vertices, shader::position_attribute, m.positions, 3, 12);
    gl::attach_floats(m.vertices, shader::normal_attribute, m.normals, 3, 12);
    m.geometry = gl::make_program("photo geometry", {{GL_VERTEX_SHADER, "photo_geometry.vert"},
                                                     {GL_FRAGMENT_SHADER, "photo_geometry.frag"}});
    gl::check("uploading the model");
    return m;
}

PhotoGeometry render_geometry(const ModelBuffers& model, std::span<const std::uint32_t> indices,
                              const Intrinsics& k, const Pose& pose, Eigen::Vector2d near_far) {
    PhotoGeometry out = empty_geometry(k);
    if (!(near_far.y() > 0) || indices.empty()) return out;
    const Triangles triangles{gl::make_buffer("triangles in frame", indices.size_bytes(), indices.data()),
                              indices.size()};
    render_maps(model, triangles, map_intrinsics(k), pose, near_far, out);
    gl::check("rendering a photo's geometry");
    return out;
}

}  // namespace vantage
