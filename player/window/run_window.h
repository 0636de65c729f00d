#pragma once
#include <vector>

#include "objects/scene_file.h"
#include "player/options/show_options.h"
#include "scene/package_reader.h"

namespace vantage {

/// Shows a scene in a window until it is closed; its first object is that of the package. Returns the exit
/// code: damaged if a damaged tile was found. Throws Error(graphics) without a display or OpenGL 4.5.
int run_window(const PackageReader& package, const ShowOptions& options,
               const std::vector<SceneObject>& objects);

}  // namespace vantage
