#pragma once
#include <string>
#include <vector>

#include "base/gl/program.h"
#include "player/view/frame_size.h"

namespace vantage {

/// A program that runs a fragment shader once per pixel of the viewport if three vertices are drawn without
/// attributes.
gl::Program full_frame_program(const char* label, const char* fragment_shader,
                               const std::vector<std::string>& defines = {});

/// Makes such a program current and binds the framebuffer `target`, with a viewport of this size. Disables
/// depth testing and blending.
void begin_full_frame(const gl::Program& program, GLuint target, FrameSize size);

}  // namespace vantage
