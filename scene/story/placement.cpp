#include "scene/story/placement.h"

#include <Eigen/Geometry>
#include <numbers>

namespace vantage {

Eigen::Matrix3d rotation_of(const Placement& placement) {
    const Eigen::Vector3d angles = placement.turn * (std::numbers::pi / 180);
    return (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
        .toRotationMatrix();
}

}  // namespace vantage
