#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pipeline/refine/poses/surface_matches.h"
#include "scene/camera/camera.h"
#include "scene/camera/small_motion.h"

namespace vantage {

/// Derivative of the pixel position with respect to the point in camera space. The point must be in front of
/// the camera.
Eigen::Matrix<double, 2, 3> pixel_derivative(const Intrinsics& k, const Eigen::Vector3d& in_camera);
/// Derivative, with respect to S, of the pixel position at which the camera sees S(x). The point x must be in
/// front of the camera.
Eigen::Matrix<double, 2, 7> motion_derivative(const Intrinsics& k, const Pose& pose, const Eigen::Vector3d& x,
                                              const MotionFrame& frame);

/// The common motion of all cameras, that is, the similarity S with which the given cameras project S(x) as
/// close as possible to where the new cameras project x. It is a least-squares solution over the tracks'
/// points, linearized for motions of a few pixels. Returns the identity if the tracks do not determine S.
Similarity common_motion(std::span<const Intrinsics> intrinsics, std::span<const Pose> given,
                         std::span<const Pose> now, std::span<const Track> tracks);

/// Median distance in pixels between the projections of the tracks' points with two sets of cameras, in one
/// photo or in all photos; 0 if there are no points.
double median_motion(std::span<const Intrinsics> intrinsics, std::span<const Pose> a, std::span<const Pose> b,
                     std::span<const Track> tracks, std::optional<std::uint32_t> photo = {});

}  // namespace vantage
