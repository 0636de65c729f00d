#pragma once
#include <Eigen/Core>

#include "player/view/view.h"

namespace vantage {

/// A ray, relative to the package's origin. Its direction may have any nonzero length.
struct Ray {
    Eigen::Vector3d from, along;
};
/// The ray through a position in the view's picture, in pixels from its upper left corner. `along` has length
/// 1.
Ray ray_through(const View& view, const Eigen::Vector2d& pixel);

}  // namespace vantage
