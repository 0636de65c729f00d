#pragma once
#include <Eigen/Core>
#include <optional>

#include "scene/camera/lens.h"

namespace vantage {

/// The intrinsics of a pinhole camera, in pixels. Pixel (0,0) covers [0,1) x [0,1); v points down.
struct Intrinsics {
    int width = 0, height = 0;
    double fx = 0, fy = 0, cx = 0, cy = 0;

    /// The same camera at another resolution.
    Intrinsics scaled(int new_width, int new_height) const;
    /// The same camera at a level of the photo's pyramid. A pixel at that level is exactly 2^level full-size
    /// pixels wide, so rounding the size up enlarges the frame.
    Intrinsics at_level(int level) const;
};

/// The rigid transform `x_cam = R * x_world + t`. The camera looks along +z; x points right, y down.
struct Pose {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();

    Eigen::Vector3d center() const;
    Eigen::Vector3d direction() const;
    /// The same pose for world coordinates measured from `origin`.
    Pose relative_to(const Eigen::Vector3d& origin) const;
};

struct Camera {
    Intrinsics intrinsics;
    Lens lens;  ///< the lens distortion of the photo as taken
    Pose cam_from_world;
};

/// A projected point: pixel coordinates and linear depth z along the optical axis.
struct Projection {
    Eigen::Vector2d pixel;
    double z;
};

/// Projects a point with a pinhole camera, without the lens. Empty for points on or behind the camera's
/// plane, or if the result is not finite.
std::optional<Projection> project(const Intrinsics& intrinsics, const Pose& cam_from_world,
                                  const Eigen::Vector3d& point);

/// True if a pixel position is inside the frame; false for NaN.
inline bool in_frame(const Intrinsics& k, const Eigen::Vector2d& pixel) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < k.width && pixel.y() < k.height;
}

/// The OpenGL clip-from-camera matrix. The matrix projects to exactly the pixels of `intrinsics`, including
/// the principal point; row 0 of the framebuffer is the photo's top row. For the clip range [0, 1], depth
/// runs from 1 at `near` to 0 at `far` (both must be positive). Depth is reversed so that floats keep their
/// precision at all distances.
Eigen::Matrix4d clip_from_cam(const Intrinsics& intrinsics, double near, double far);

/// The distances of the near and far planes for depths from `nearest` to `farthest`; the range is slightly
/// widened. The near distance is at least 1e-7 (the resolution of single-precision positions) times the
/// smaller of `farthest` and `reach`, the distance up to which the surface should be drawn accurately. {0, 0}
/// if nothing is in front of the camera.
Eigen::Vector2d clip_range(double nearest, double farthest, double reach);

/// Throws Error(input) naming `who` unless sizes and focal lengths are positive, all values (including the
/// lens's) are finite, and R is orthonormal with determinant +1 to within 1e-3. Then replaces R with the
/// nearest rotation.
void validate(Camera& camera, const std::string& who);

}  // namespace vantage
