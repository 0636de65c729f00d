#include "scene/story/placement.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace vantage {

Eigen::Matrix3d rotation_of(const Placement& placement) {
    const Eigen::Vector3d angles = placement.turn * (std::numbers::pi / 180);
    return (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

Placement placement_of(const Similarity& matrix, const Eigen::Vector3d& middle) {
    const Eigen::Matrix3d& R = matrix.R;
    // If the angle about y is a right angle, many angles about z give the same R; 0 is used.
    const double z = std::atan2(R(1, 0), R(0, 0)), y = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0))),
                 x = std::atan2(std::sin(z) * R(0, 2) - std::cos(z) * R(1, 2),
                                std::cos(z) * R(1, 1) - std::sin(z) * R(0, 1));
    return {matrix(middle) - middle, Eigen::Vector3d(x, y, z) * (180 / std::numbers::pi), matrix.scale};
}

}  // namespace vantage
