#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Turns photos by 90 degrees if the features that they share with their neighbors show that this is
/// necessary, although their size does not. Adds a warning about each group of photos with an ambiguous
/// orientation.
void settle_turns(SceneInput& scene, unsigned threads);

}  // namespace vantage
