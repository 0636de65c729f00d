#include "base/values/principal_axes.h"

#include <Eigen/Eigenvalues>

namespace vantage {

PrincipalAxes principal_axes(const Eigen::Matrix3d& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace vantage
