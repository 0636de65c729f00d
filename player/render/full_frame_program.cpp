#include "player/render/full_frame_program.h"

namespace vantage {

gl::Program full_frame_program(const char* label, const char* fragment_shader,
                               const std::vector<std::string>& defines) {
    return gl::make_program(
        label, {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, fragment_shader}}, defines);
}

void begin_full_frame(const gl::Program& program, GLuint target, FrameSize size) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program.id());
}

}  // namespace vantage
