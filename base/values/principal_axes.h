#pragma once

#include <Eigen/Core>

namespace vantage {

/// Of a symmetric matrix: its eigenvalues, ascending, and its eigenvectors of length 1, as columns in the
/// same order.
struct PrincipalAxes {
    Eigen::Vector3d values;
    Eigen::Matrix3d axes;
};

PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric);

}  // namespace vantage
