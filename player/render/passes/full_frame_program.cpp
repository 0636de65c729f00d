#include "player/render/passes/full_frame_program.h"

#include "player/render/passes/frame_targets.h"

namespace vantage {

gl::Program full_frame_program(const char* label, const char* fragment_shader,
                               const std::vector<std::string>& defines) {
    return gl::make_program(
        label, {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, fragment_shader}}, defines);
}

void begin_full_frame(const gl::Program& program, GLuint target, FrameSize size) {
    bind_target(target, size);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program.id());
}

}  // namespace vantage
