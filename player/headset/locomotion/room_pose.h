#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace vantage {

/// A pose in the room in which a headset is tracked, in meters; x: right, y: up, -z: forward.
struct RoomPose {
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< unit length
    Eigen::Vector3d at = Eigen::Vector3d::Zero();

    Eigen::Vector3d ahead() const { return -(turn * Eigen::Vector3d::UnitZ()); }
};

/// Whether all numbers are finite and the rotation is nonzero.
inline bool is_valid(const RoomPose& pose) {
    return pose.at.allFinite() && std::abs(pose.turn.squaredNorm() - 1) < 0.01;
}

}  // namespace vantage
