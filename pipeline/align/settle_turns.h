#pragma once
#include "pipeline/input/scene_input.h"

namespace vantage {

/// Turns a photo by 90 degrees if the features that it shares with its neighbors show that this is necessary,
/// even if its size does not. Adds a warning about each group of photos with an ambiguous orientation.
void settle_turns(SceneInput& scene, unsigned threads);

}  // namespace vantage
