#pragma once
#include <Eigen/Core>
#include <array>

#include "player/view/navigation.h"

namespace vantage {

/// How two fingers on the screen moved what is between them: by a similarity. Pixels, x right, y down.
struct Pinch {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< between the fingers, after it
    Eigen::Vector2d moved = Eigen::Vector2d::Zero();   ///< the center
    double spread = 1;                                 ///< their distance over what it was
    double turned = 0;                                 ///< radians, clockwise
};

using FingerPair = std::array<Eigen::Vector2d, 2>;

/// From one pair of positions to the next. Fingers closer than a few pixels neither spread nor turn.
Pinch pinch_between(const FingerPair& before, const FingerPair& now);
/// One after the other.
Pinch then(const Pinch& first, const Pinch& second);

/// Moves the camera so that a point, which was under the fingers' center before, follows them: to the side,
/// closer or away as approach_point() does, and around the line of sight. `view`: what was shown from there.
void follow_pinch(Navigation& n, const Pinch& pinch, const Eigen::Vector3d& point, const View& view,
                  double nearest, double farthest);

}  // namespace vantage
