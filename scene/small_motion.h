#pragma once
#include <Eigen/Core>

#include "scene/similarity.h"

namespace vantage {

/// A small similarity: rotation about the middle (rad), translation (units of `size`), ln scale.
using SmallMotion = Eigen::Matrix<double, 7, 1>;
/// Where small motions are about, and their unit of length.
struct MotionFrame {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double size = 1;
};
Similarity similarity(const SmallMotion& motion, const MotionFrame& frame);

}  // namespace vantage
