#pragma once
#include <span>
#include <string>

#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"
#include "player/window/glfw_window.h"

namespace vantage {

/// What is shown without a package: those that were opened before, and how to open another one, or drop one
/// here. Returns the file that was chosen, or empty if the window was closed. `recent`: the last one first.
/// `trouble`: why the file chosen before could not be opened, or empty. `places`: file for the positions of
/// the controls, or empty.
std::string start_page(GlfwWindow& window, WindowState& state, Controls& controls,
                       std::span<const std::string> recent, const std::string& trouble,
                       const std::string& places);

}  // namespace vantage
