#pragma once
#include <Eigen/Core>
#include <optional>

#include "scene/lens.h"

namespace vantage {

/// Pinhole intrinsics in pixels. Pixel (0,0) covers [0,1)x[0,1), v grows downwards.
struct Intrinsics {
    int width = 0, height = 0;
    double fx = 0, fy = 0, cx = 0, cy = 0;

    /// The same camera with pixels `s` times as many along each side.
    Intrinsics scaled(int new_width, int new_height) const;
    /// The same camera at a level of the photo's pyramid: a level's pixel is 2^level pixels wide even where
    /// the size is odd, so the frame grows by the rounding.
    Intrinsics at_level(int level) const;
};

/// Rigid transform `x_cam = R * x_world + t`; the camera looks along +z, x right, y down.
struct Pose {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();

    Eigen::Vector3d center() const { return -R.transpose() * t; }
    Eigen::Vector3d direction() const { return R.row(2).transpose(); }
    /// The same pose for world coordinates measured from `origin`.
    Pose relative_to(const Eigen::Vector3d& origin) const { return {R, t + R * origin}; }
};

struct Camera {
    Intrinsics intrinsics;
    Lens lens;  ///< how the photo as taken deviates from the pinhole
    Pose cam_from_world;
};

/// A projected point: pixel coordinates and linear depth z along the optical axis.
struct Projection {
    Eigen::Vector2d pixel;
    double z;
};

/// Pinhole projection, lens ignored. Empty for points on or behind the camera plane or not finite.
std::optional<Projection> project(const Intrinsics& intrinsics, const Pose& cam_from_world,
                                  const Eigen::Vector3d& point);

/// A pixel position is within the frame; one that is no number is not.
inline bool in_frame(const Intrinsics& k, const Eigen::Vector2d& pixel) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < k.width && pixel.y() < k.height;
}

/// OpenGL clip-from-camera matrix whose pixels are exactly those of `intrinsics` (principal point
/// included), row 0 of the framebuffer being the photo's top row. Depth from 1 at `near` to 0 at `far`, both
/// > 0, for a clip range from 0 to 1: so floats tell all depths apart to their last digits.
Eigen::Matrix4d clip_from_cam(const Intrinsics& intrinsics, double near, double far);

/// Near and far plane for depths from `nearest` to `farthest`, widened; what reaches to the camera's plane is
/// cut as near as positions in single precision tell. {0, 0} where nothing lies in front.
Eigen::Vector2d clip_range(double nearest, double farthest);

/// Throws Error(input) naming `who` unless sizes are positive, focal lengths positive, all (the lens, too)
/// finite and R orthonormal with determinant +1 (to 1e-3; smaller errors are removed).
void validate(Camera& camera, const std::string& who);

}  // namespace vantage
