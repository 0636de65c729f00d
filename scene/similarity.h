#pragma once
#include <Eigen/Core>

#include "scene/camera.h"

namespace vantage {

/// y = scale R x + t.
struct Similarity {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
    double scale = 1;  ///< above 0

    Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return scale * (R * x) + t; }
};

/// A rotation times a scale, and a translation: 3 rows of 4 numbers.
inline Eigen::Matrix<double, 3, 4> matrix_of(const Similarity& s) {
    Eigen::Matrix<double, 3, 4> m;
    m << s.scale * s.R, s.t;
    return m;
}

inline Similarity inverse(const Similarity& s) {
    const Eigen::Matrix3d R = s.R.transpose();
    return {R, -(R * s.t) / s.scale, 1 / s.scale};
}

/// The camera that projects x to where `pose` projects s(x).
inline Pose compose(const Pose& pose, const Similarity& s) {
    return {pose.R * s.R, (pose.R * s.t + pose.t) / s.scale};
}

}  // namespace vantage
