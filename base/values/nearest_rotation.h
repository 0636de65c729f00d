#pragma once

#include <Eigen/Core>

namespace vantage {

/// The orthogonal matrix closest to a matrix; it is a reflection if the matrix has a negative determinant.
Eigen::Matrix3d nearest_orthogonal(const Eigen::Matrix3d& m);

/// The rotation closest to a matrix (W. Kabsch, "A discussion of the solution for the best rotation to relate
/// two sets of vectors", 1978).
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m);

}  // namespace vantage
