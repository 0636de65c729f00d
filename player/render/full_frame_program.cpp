#include "player/render/full_frame_program.h"

namespace vantage {

gl::Program full_frame_program(const char* label, const char* fragment_shader,
                               const std::vector<std::string>& defines) {
    return gl::make_program(
        label, {{GL_VERTEX_SHADER, "resolve.vert"}, {GL_FRAGMENT_SHADER, fragment_shader}}, defines);
}

}  // namespace vantage
