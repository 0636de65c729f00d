#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "gl/context.h"

namespace vantage {

struct WindowOptions {
    int frames = 0;      ///< 0: until the window is closed
    bool fresh = false;  ///< neither read nor write remembered settings
    gl::Debug debug_gl = gl::debug_from_environment();
    std::string controls;    ///< file for the positions of the controls
    std::string screenshot;  ///< file for the last frame
};
void add_window_options(CLI::App& app, WindowOptions& options);

}  // namespace vantage
