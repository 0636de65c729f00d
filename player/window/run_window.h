#pragma once
#include <vector>

#include "player/options/show_options.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Shows a scene in a window until it is closed. Without objects, the window opens the package of the
/// options, or shows the start page if they name none or it cannot be opened. Returns the exit code: damaged
/// if a damaged tile was found. Throws Error(graphics) without a display or OpenGL 4.5, and if the first
/// package cannot be shown.
int run_window(const ShowOptions& options, const std::vector<SceneObject>& objects);

}  // namespace vantage
