#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Turns photos by 90 degrees whose size does not show that they need it, but whose neighbors do, and adds a
/// warning about each group of photos with an open orientation.
void settle_turns(SceneInput& scene, unsigned threads);

}  // namespace vantage
