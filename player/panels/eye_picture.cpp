#include "player/panels/eye_picture.h"

#include "shaders/contract.h"

namespace vantage {

Eigen::Matrix4d clip_from_origin(const EyePicture& eye) {
    // The depth range is arbitrary: there is no depth test.
    Eigen::Matrix4d clip = clip_from_origin(eye.view, {eye.nearest, 1e15 * eye.nearest});
    if (eye.flip) clip.row(1) *= -1;
    return clip;
}

void begin_over_picture(const gl::Program& program, const EyePicture& eye) {
    const FrameSize size = frame_size(eye.view);
    glBindFramebuffer(GL_FRAMEBUFFER, eye.target);
    glViewport(0, 0, size.width, size.height);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program.id());
    const ModelDepth& depth = eye.depth;
    glUniform1i(shader::hides_uniform, depth.texture != 0);
    glUniform2f(shader::hiding_terms_uniform, float(depth.terms.x()), float(depth.terms.y()));
    glUniform2f(shader::hiding_scale_uniform, float(depth.frame.width) / float(size.width),
                float(depth.frame.height) / float(size.height));
    glUniform1i(shader::hiding_rows_uniform, eye.flip ? size.height : 0);
    glBindTextureUnit(shader::depth_unit, depth.texture);
}

void end_over_picture() {
    glDisable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBindTextureUnit(shader::depth_unit, 0);  // the depth may be a render target next
}

}  // namespace vantage
