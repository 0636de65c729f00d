#pragma once
#include <Eigen/Core>

#include "scene/camera/similarity.h"

namespace vantage {

/// A small similarity: rotation about the middle (rad), translation (units of `size`), ln scale.
using SmallMotion = Eigen::Matrix<double, 7, 1>;
/// Where small motions are about, and their unit of length.
struct MotionFrame {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double size = 1;
};
Similarity similarity(const SmallMotion& motion, const MotionFrame& frame);

/// Sums of J^T J and J^T r over all residuals r with derivatives J.
struct NormalEquations {
    Eigen::Matrix<double, 7, 7> normal = Eigen::Matrix<double, 7, 7>::Zero();
    SmallMotion right = SmallMotion::Zero();
};
/// The motion of least squares; directions that no residual tells of stay at zero. Not finite if a sum is
/// not.
SmallMotion solved(NormalEquations sums);

}  // namespace vantage
