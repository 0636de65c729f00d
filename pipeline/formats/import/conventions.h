#pragma once
#include <Eigen/Core>
#include <cmath>

#include "scene/camera.h"

/// The one place where other programs' camera conventions become ours (+z forward, x right, y down).
namespace vantage {

/// Bundler looks along -z with y up: both the camera's y and z axes turn.
inline Pose from_bundler(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
    const Eigen::Vector3d turn(1, -1, -1);
    return {turn.asDiagonal() * R, turn.asDiagonal() * t};
}

/// MeshLab (VCG) looks along -z with y up, too; its translation is the camera's centre, negated.
inline Pose from_meshlab(const Eigen::Matrix3d& R, const Eigen::Vector3d& minus_center) {
    return from_bundler(R, R * minus_center);
}

/// COLMAP's cam_from_world is ours; the quaternion is (w, x, y, z).
inline Pose from_colmap(double w, double x, double y, double z, const Eigen::Vector3d& t) {
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n, x /= n, y /= n, z /= n;
    Eigen::Matrix3d R;
    R << 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),   //
        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y);
    return {R, t};
}

}  // namespace vantage
