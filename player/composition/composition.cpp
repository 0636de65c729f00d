#include "player/composition/composition.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/gl/context.h"
#include "player/render/passes/full_frame_program.h"
#include "shaders/contract.h"

namespace vantage {
void Composition::fit(FrameSize size, std::size_t objects) {
    if (size == allocated_ && objects == layers_.size()) return;
    allocated_ = size;
    const auto [width, height] = size;
    layers_.clear();
    nearest_target_ = {};
    colors_ = {}, depths_ = {}, nearest_ = {};
    colors_ = gl::make_texture_array("objects", GL_RGBA8, width, height, int(objects), GL_NEAREST);
    depths_ = gl::make_texture_array("objects' depth", GL_R32F, width, height, int(objects), GL_NEAREST);
    for (int i = 0; i < int(objects); ++i)
        layers_.push_back({gl::make_layer_framebuffer("color of an object", colors_, i),
                           gl::make_layer_framebuffer("depth of an object", depths_, i)});
    depth_program_ = full_frame_program("object depth", "object_depth.frag");
    compose_program_ =
        full_frame_program("compose", "compose.frag", {"MAX_OBJECTS " + std::to_string(objects)});
    if (!no_vertices_) no_vertices_ = gl::make_vertex_array("no vertices");
}

void Composition::copy_depth(const ObjectFrame& frame, const Layer& layer) {
    bind_target(layer.depth.id(), frame_);
    glUseProgram(depth_program_.id());
    const FrameTargets& targets = frame.renderer->resources().targets;
    const Eigen::Vector2d& terms = targets.depth_terms;
    glUniform3f(shader::depth_terms_uniform, float(terms.x()), float(terms.y()), float(frame.scale));
    glBindTextureUnit(shader::depth_unit, targets.surface().depth.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Composition::show(std::span<const ObjectFrame> frames, const View& view, const RenderSettings& settings,
                       const ShowTarget& target) {
    frame_ = {view.intrinsics.width, view.intrinsics.height};
    fit(enclosing(frame_, settings.capacity), std::max<std::size_t>(1, frames.size()));
    opacities_.clear();
    for (const ObjectFrame& f : frames) opacities_.push_back(float(f.opacity));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const ObjectFrame& f = frames[i];
        f.renderer->show(f.view, f.settings, {layers_[i].color.id(), false, target.eye});
        glBindVertexArray(no_vertices_.id());
        copy_depth(f, layers_[i]);
    }
    begin_full_frame(compose_program_, target.framebuffer, frame_);
    glBindVertexArray(no_vertices_.id());
    glUniform2i(shader::frame_size_uniform, frame_.width, frame_.height);
    glUniform1i(shader::objects_uniform, GLint(frames.size()));
    glUniform1fv(shader::compose_opacity_uniform, GLsizei(opacities_.size()), opacities_.data());
    glUniform1i(shader::compose_flip_uniform, target.flip);
    glUniform1i(shader::compose_fill_uniform, settings.fill_holes);
    glUniform3fv(shader::compose_plain_background_uniform, 1, settings.plain_background.top.data());
    glUniform3fv(shader::compose_plain_background_bottom_uniform, 1, settings.plain_background.bottom.data());
    glUniform1f(shader::compose_soft_edges_uniform, float(settings.plain_background.soft_edges));
    glBindTextureUnit(shader::object_colors_unit, colors_.id());
    glBindTextureUnit(shader::object_depths_unit, depths_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    gl::check("composing objects");
}

const gl::Texture& Composition::nearest_depth(double near) {
    if (!nearest_) {
        nearest_ =
            gl::make_texture_2d("nearest object", GL_R32F, allocated_.width, allocated_.height, GL_NEAREST);
        nearest_target_ = gl::make_framebuffer("nearest object", std::array{nearest_.id()}, 0);
        nearest_program_ = full_frame_program("nearest object", "nearest_object.frag",
                                              {"MAX_OBJECTS " + std::to_string(layers_.size())});
    }
    begin_full_frame(nearest_program_, nearest_target_.id(), frame_);
    glUniform1i(shader::objects_uniform, GLint(opacities_.size()));
    glUniform1fv(shader::compose_opacity_uniform, GLsizei(opacities_.size()), opacities_.data());
    glUniform1f(shader::nearest_shown_uniform, float(near));
    glBindTextureUnit(shader::object_depths_unit, depths_.id());
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    gl::check("finding the nearest object");
    return nearest_;
}

}  // namespace vantage
