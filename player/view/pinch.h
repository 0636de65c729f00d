#pragma once
#include <Eigen/Core>
#include <array>

#include "player/view/navigation.h"

namespace vantage {

/// The similarity transform given by the movement of two fingers. Pixels, x right, y down.
struct Pinch {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< midpoint of the fingers, after the movement
    Eigen::Vector2d moved = Eigen::Vector2d::Zero();   ///< of the center
    double spread = 1;  ///< ratio of the fingers' distance to the previous distance
    double turned = 0;  ///< radians, clockwise
};

using FingerPair = std::array<Eigen::Vector2d, 2>;

/// The movement between two pairs of positions. If the fingers are within a few pixels of each other, the
/// movement contains neither scaling nor rotation.
Pinch pinch_between(const FingerPair& before, const FingerPair& now);
/// The composition of two movements.
Pinch then(const Pinch& first, const Pinch& second);

/// Moves the camera so that a point that was under the fingers' center follows the fingers. The camera moves
/// sideways, changes its distance like approach_point(), and turns about the viewing direction. `view`: the
/// view before the movement.
void follow_pinch(Navigation& n, const Pinch& pinch, const Eigen::Vector3d& point, const View& view,
                  double nearest, double farthest);

}  // namespace vantage
