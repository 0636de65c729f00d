#pragma once
#include <vector>

#include "player/options/show_options.h"
#include "scene/story/scene_file.h"

namespace vantage {

/// Shows a scene in a headset until the user quits in the headset or closes the mirror window. Returns the
/// exit code. Throws Error, in particular Error(graphics) if there is no runtime or no headset.
int run_headset(const ShowOptions& options, const std::vector<SceneObject>& objects);

}  // namespace vantage
