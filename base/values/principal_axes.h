#pragma once

#include <Eigen/Core>

namespace vantage {

/// The eigenvalues of a symmetric matrix in ascending order, and its unit eigenvectors as columns in the same
/// order.
struct PrincipalAxes {
    Eigen::Vector3d values;
    Eigen::Matrix3d axes;
};

PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

}  // namespace vantage
