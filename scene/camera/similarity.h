#pragma once
#include <Eigen/Core>

#include "scene/camera/camera.h"

namespace vantage {

/// y = scale R x + t.
struct Similarity {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
    double scale = 1;  ///< positive

    Eigen::Vector3d operator()(const Eigen::Vector3d& x) const;
};

/// The similarity as a matrix of 3 rows of 4 numbers: a rotation times a scale, and a translation.
Eigen::Matrix<double, 3, 4> matrix_of(const Similarity& s);

Similarity inverse(const Similarity& s);

/// The camera that projects x to where `pose` projects s(x).
Pose compose(const Pose& pose, const Similarity& s);

}  // namespace vantage
