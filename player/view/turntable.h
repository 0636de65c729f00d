#pragma once
#include <vector>

#include "player/view/navigation.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Start of a turn around the whole model: elevated by 20 degrees, on the side of the photos, at a distance
/// at which the model stays inside a frame of `aspect`, width over height, in all directions.
Navigation framed(const PackageReader& package, double aspect);

/// `count` positions around the target of `start`, evenly spaced: a full turn for an arc of 360 degrees, in
/// which the first follows the last; below 360, swinging to both sides of `start` and back.
std::vector<Navigation> turntable(const Navigation& start, int count, double arc = 360);

}  // namespace vantage
