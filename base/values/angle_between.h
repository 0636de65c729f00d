#pragma once
#include <Eigen/Geometry>
#include <cmath>

namespace vantage {

/// The angle between two vectors of any length, in radians; accurate for small angles as well.
template <class A, class B>
typename A::Scalar angle_between(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace vantage
