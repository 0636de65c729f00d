#pragma once
#include <Eigen/Core>

#include "scene/camera/similarity.h"

namespace vantage {

/// A small similarity: a rotation about the center (in radians), a translation (in units of `size`), and the
/// ln of a scale.
using SmallMotion = Eigen::Matrix<double, 7, 1>;
/// The center and the unit of length of small motions.
struct MotionFrame {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double size = 1;
};
Similarity similarity(const SmallMotion& motion, const MotionFrame& frame);

/// The sums of J^T J and J^T r over all residuals r, whose derivatives are J.
struct NormalEquations {
    Eigen::Matrix<double, 7, 7> normal = Eigen::Matrix<double, 7, 7>::Zero();
    SmallMotion right = SmallMotion::Zero();
};
/// The least-squares motion; directions that no residual constrains stay at zero. The result is not finite if
/// a sum is not finite.
SmallMotion solved(NormalEquations sums);

}  // namespace vantage
