#pragma once
#include <Eigen/Geometry>
#include <cmath>

namespace vantage {

/// The angle in radians between two vectors of any length; accurate for small angles as well.
template <class A, class B>
typename A::Scalar angle_between(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace vantage
