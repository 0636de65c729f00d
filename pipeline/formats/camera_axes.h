#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "scene/camera/camera.h"

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

/// The pose with this camera-to-world rotation and this camera center.
inline Pose from_camera_to_world(const Eigen::Matrix3d& R, const Eigen::Vector3d& center) {
    return {R.transpose(), -R.transpose() * center};
}

/// Converts a camera-to-world rotation from axes with y up and z backward, as in OpenGL, to ours.
inline Eigen::Matrix3d backward(const Eigen::Matrix3d& R) {
    return R * Eigen::Vector3d(1, -1, -1).asDiagonal();
}

/// The lens with these coefficients of r^2, r^4, r^6, r^8, with OpenCV's p1 and p2, and with the skew in
/// focal lengths.
inline Lens brown_lens(const std::array<double, 4>& k, double p1, double p2, double skew) {
    if (k[3] != 0 || skew != 0) return {LensModel::brown, {k[0], k[1], p1, p2, k[2], k[3], skew}};
    const Lens lens{LensModel::opencv, {k[0], k[1], p1, p2, k[2]}};
    return lens.distorts() ? lens : Lens{};
}

/// A COLMAP camera model. Elements of `focal_center` and `distortion` are indices into COLMAP's parameters.
struct ColmapModel {
    const char* name;
    std::size_t parameters;
    std::array<int, 4> focal_center;  ///< fx fy cx cy
    LensModel lens;
    std::vector<int> distortion{};  ///< in the order of Lens::p; further coefficients are 0
};
/// The models, in the order of their IDs in COLMAP.
std::span<const ColmapModel> colmap_models();

/// The pose of an image in COLMAP, whose axes are those used here. The quaternion (w, x, y, z) need not be
/// normalized.
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
