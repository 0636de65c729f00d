#pragma once
#include <optional>

#include "player/headset/locomotion/stance.h"
#include "player/view/view.h"

namespace vantage {

/// What one eye of a headset sees: from where, and between which directions, as tangents of the angles to
/// its axis; left and down are below 0 unless all of it is beside the axis.
struct EyeFrustum {
    RoomPose pose;
    double left = -1, right = 1, up = 1, down = -1;
};

/// Angles in radians, as headsets state them. Exchanged ones, for pictures that are upside down or
/// mirrored, are put in order. Nothing unless they are finite, within 89.9 degrees of the axis, and apart.
std::optional<EyeFrustum> eye_frustum(const RoomPose& pose, double left, double right, double up,
                                      double down);

/// The view of an eye, in a picture of this size.
View view_of_eye(const Stance& stance, const EyeFrustum& eye, FrameSize size);

}  // namespace vantage
