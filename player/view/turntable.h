#pragma once
#include <vector>

#include "player/view/navigation.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// The start of a turn around the whole model: elevated by 20 degrees, on the side of the photos, and so far
/// away that the model stays inside the frame from all directions. `aspect`: the frame's width over its
/// height.
Navigation framed(const PackageReader& package, double aspect);

/// `count` evenly spaced positions around the target of `start`. An arc of 360 degrees makes a full turn, in
/// which the first position follows the last; a smaller arc swings to both sides of `start` and back.
std::vector<Navigation> turntable(const Navigation& start, int count, double arc = 360);

}  // namespace vantage
