#pragma once
#include <span>
#include <string>

#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"
#include "player/window/glfw_window.h"

namespace vantage {

/// The start page, which is shown without a package. It shows recent files with pictures; the user
/// can also choose or drop a file. Returns the chosen file, or empty if the window was closed. `files`: the
/// recent ones, most recent first. `trouble`: the error of the previously chosen file, or empty. `places`:
/// the file to which the positions of the controls are written, or empty.
std::string start_page(GlfwWindow& window, WindowState& state, Controls& controls,
                       std::span<const std::string> files, const std::string& trouble,
                       const std::string& places);

}  // namespace vantage
