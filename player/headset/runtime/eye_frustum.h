#pragma once
#include <optional>

#include "player/headset/locomotion/stance.h"
#include "player/view/view.h"

namespace vantage {

/// Pose and frustum of one eye of a headset. The frustum is given by the tangents of the angles from the
/// eye's axis; left and down are negative unless the frustum is entirely to one side of the axis.
struct EyeFrustum {
    RoomPose pose;
    double left = -1, right = 1, up = 1, down = -1;
};

/// Angles in radians, as headsets report them. Swapped angles of upside-down or mirrored pictures are sorted.
/// Returns nullopt unless all angles are finite, within 89.9 degrees of the axis, and distinct.
std::optional<EyeFrustum> eye_frustum(const RoomPose& pose, double left, double right, double up,
                                      double down);

/// The view of an eye, in a picture of this size.
View view_of_eye(const Stance& stance, const EyeFrustum& eye, FrameSize size);

}  // namespace vantage
