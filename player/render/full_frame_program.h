#pragma once
#include <string>
#include <vector>

#include "gl/program.h"

namespace vantage {

/// A program that runs a fragment shader once per pixel of the viewport: three vertices without attributes.
gl::Program full_frame_program(const char* label, const char* fragment_shader,
                               const std::vector<std::string>& defines = {});

}  // namespace vantage
