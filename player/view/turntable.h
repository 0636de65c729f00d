#pragma once
#include <vector>

#include "player/view/navigation.h"
#include "scene/package/package_reader.h"

namespace vantage {

/// A part of a turn about the up direction, in degrees; 0 is the present view.
struct Arc {
    double from = -180, to = 180;
};

/// The start of a turn around the whole model: elevated by 20 degrees, on the side of the photos, and so far
/// away that the model stays inside the frame from all directions. `aspect`: the frame's width over its
/// height.
Navigation framed(const PackageReader& package, double aspect);

/// `count` positions around the target of `start`, evenly spaced in time; the first, which is `start`,
/// follows the last. An arc of 360 degrees makes a full turn; in a smaller arc, the camera swings to both
/// ends.
std::vector<Navigation> turntable(const Navigation& start, int count, const Arc& arc = {});

}  // namespace vantage
