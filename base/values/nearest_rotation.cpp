#include "base/values/nearest_rotation.h"

#include <Eigen/SVD>

namespace vantage {
namespace {

Eigen::JacobiSVD<Eigen::Matrix3d> decomposed(const Eigen::Matrix3d& m) {
    return Eigen::JacobiSVD<Eigen::Matrix3d>(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
}

}  // namespace

Eigen::Matrix3d nearest_orthogonal(const Eigen::Matrix3d& m) {
    const auto svd = decomposed(m);
    return svd.matrixU() * svd.matrixV().transpose();
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& m) {
    const auto svd = decomposed(m);
    const double mirror = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixU() * Eigen::Vector3d(1, 1, mirror).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace vantage
