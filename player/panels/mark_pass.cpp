#include "player/panels/mark_pass.h"

#include <cmath>

#include "base/gl/context.h"
#include "shaders/contract.h"

namespace vantage {
namespace {

gl::VertexArray mark_vertices() {
    gl::VertexArray out = gl::make_vertex_array("marks");
    const GLuint id = out.id();
    const auto enable = [&](int attribute) {
        glVertexArrayAttribBinding(id, GLuint(attribute), 0);
        glEnableVertexArrayAttrib(id, GLuint(attribute));
    };
    for (int i = 0; i < 4; ++i) {
        const auto offset = GLuint(offsetof(Mark, points) + std::size_t(i) * sizeof(Mark::points[0]));
        glVertexArrayAttribFormat(id, GLuint(shader::points_attribute + i), 3, GL_FLOAT, GL_FALSE, offset);
        enable(shader::points_attribute + i);
    }
    glVertexArrayAttribFormat(id, shader::sizes_attribute, 4, GL_FLOAT, GL_FALSE, offsetof(Mark, sizes));
    enable(shader::sizes_attribute);
    for (int i = 0; i < 2; ++i) {
        glVertexArrayAttribFormat(id, GLuint(shader::colors_attribute + i), 4, GL_UNSIGNED_BYTE, GL_TRUE,
                                  GLuint(offsetof(Mark, colors) + 4 * std::size_t(i)));
        enable(shader::colors_attribute + i);
    }
    glVertexArrayAttribIFormat(id, shader::kind_attribute, 1, GL_UNSIGNED_INT, offsetof(Mark, kind));
    enable(shader::kind_attribute);
    glVertexArrayAttribFormat(id, shader::layer_attribute, 1, GL_FLOAT, GL_FALSE, offsetof(Mark, layer));
    enable(shader::layer_attribute);
    glVertexArrayBindingDivisor(id, 0, 1);
    return out;
}

void set_view(const EyePicture& eye, const Eigen::Matrix4f& clip) {
    const Intrinsics& k = eye.view.intrinsics;
    const Eigen::Vector3f center = eye.view.cam_from_origin.center().cast<float>();
    glUniformMatrix4fv(shader::clip_from_origin_uniform, 1, GL_FALSE, clip.data());
    glUniform2f(shader::half_frame_uniform, float(k.width) / 2, float(k.height) / 2);
    glUniform1f(shader::mark_focal_uniform, float(std::sqrt(k.fx * k.fy)));
    glUniform3fv(shader::mark_eye_uniform, 1, center.data());
    glUniform1f(shader::nearest_uniform, float(eye.nearest));
}

}  // namespace

MarkPass::MarkPass()
    : program_(
          gl::make_program("marks", {{GL_VERTEX_SHADER, "mark.vert"}, {GL_FRAGMENT_SHADER, "mark.frag"}})),
      vertices_(mark_vertices()) {}

void MarkPass::upload(const Marks& marks) {
    const std::span bytes = std::as_bytes(std::span(marks.marks));
    marks_.begin(bytes.size());
    marks_.write(bytes);
    runs_.assign(marks.runs.begin(), marks.runs.end());
}

void MarkPass::draw(const EyePicture& eye) {
    const Eigen::Matrix4f clip = clip_from_origin(eye).cast<float>();
    if (!clip.allFinite() || runs_.empty()) return;
    begin_over_picture(program_, eye);
    set_view(eye, clip);
    glVertexArrayVertexBuffer(vertices_.id(), 0, marks_.id(), 0, sizeof(Mark));
    glBindVertexArray(vertices_.id());
    for (const Marks::Run& run : runs_) {
        glBindTextureUnit(shader::shown_picture_unit, run.texture);
        glUniform1i(shader::picture_decodes_uniform, run.decodes);
        glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, GLsizei(run.count), GLuint(run.first));
    }
    end_over_picture();
    gl::check("drawing marks");
}

}  // namespace vantage
