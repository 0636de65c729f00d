#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace vantage {

struct WindowOptions {
    int frames = 0;          ///< 0: until the window is closed
    bool fresh = false;      ///< neither read nor write remembered settings
    bool debug_gl = false;   ///< debug context of OpenGL
    std::string controls;    ///< file for the positions of the controls
    std::string screenshot;  ///< file for the last frame
};
void add_window_options(CLI::App& app, WindowOptions& options);

}  // namespace vantage
