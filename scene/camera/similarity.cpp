#include "scene/camera/similarity.h"

namespace vantage {

Eigen::Vector3d Similarity::operator()(const Eigen::Vector3d& x) const { return scale * (R * x) + t; }

Eigen::Matrix<double, 3, 4> matrix_of(const Similarity& s) {
    Eigen::Matrix<double, 3, 4> m;
    m << s.scale * s.R, s.t;
    return m;
}

Similarity inverse(const Similarity& s) {
    const Eigen::Matrix3d R = s.R.transpose();
    return {R, -(R * s.t) / s.scale, 1 / s.scale};
}

Pose compose(const Pose& pose, const Similarity& s) {
    return {pose.R * s.R, (pose.R * s.t + pose.t) / s.scale};
}

}  // namespace vantage
