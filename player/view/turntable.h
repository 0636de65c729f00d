#pragma once
#include <vector>

#include "player/view/navigation.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// Where a turn around the whole model starts: 20 degrees above its middle, on the side of the photos, at a
/// distance from which it stays inside a frame of `aspect`, width over height, whichever way it is turned.
Navigation framed(const PackageReader& package, double aspect);

/// `count` positions around the target of `start`, evenly spaced: once around for an arc of 360 degrees, so
/// that the first would follow the last; for less, swinging to both sides of `start` and back.
std::vector<Navigation> turntable(const Navigation& start, int count, double arc = 360);

}  // namespace vantage
