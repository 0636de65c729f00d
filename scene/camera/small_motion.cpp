#include "scene/camera/small_motion.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace vantage {

Similarity similarity(const SmallMotion& d, const MotionFrame& frame) {
    const Eigen::Vector3d turn = d.head<3>();
    Similarity out;
    out.R = Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).toRotationMatrix();
    out.scale = std::exp(d(6));
    out.t = frame.middle + frame.size * Eigen::Vector3d(d.segment<3>(3)) - out.scale * (out.R * frame.middle);
    return out;
}

SmallMotion solved(NormalEquations sums) {
    sums.normal.diagonal().array() += 1e-9 * sums.normal.diagonal().maxCoeff() + 1e-300;
    return sums.normal.ldlt().solve(sums.right);
}

}  // namespace vantage
