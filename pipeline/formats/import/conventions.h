#pragma once
#include <Eigen/Core>
#include <cmath>

#include "scene/camera.h"

/// Conversions from other programs' camera conventions to ours: x right, y down, z forward.
namespace vantage {

/// Bundler's cameras look along -z with y up, so the y and z axes change sign.
inline Pose from_bundler(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
    const Eigen::Vector3d flip(1, -1, -1);
    return {flip.asDiagonal() * R, flip.asDiagonal() * t};
}

/// MeshLab's cameras (VCG) also look along -z with y up; the translation is the negated camera center.
inline Pose from_meshlab(const Eigen::Matrix3d& R, const Eigen::Vector3d& minus_center) {
    return from_bundler(R, R * minus_center);
}

/// COLMAP's convention is ours. The quaternion (w, x, y, z) need not be normalized.
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
