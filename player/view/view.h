#pragma once
#include <Eigen/Core>
#include <array>
#include <span>

#include "player/view/frame_size.h"
#include "scene/camera/camera.h"
#include "scene/package/package_format.h"

namespace vantage {

/// The exposure of a view: `gain` is relative to the mean photo's exposure, and `vignetting` is that of the
/// lens toward the corners, as in PhotoRecord.
struct Exposure {
    std::array<float, 3> gain{1, 1, 1}, vignetting{0, 0, 0};
    std::uint32_t image_set = 0;  ///< the image set to which the gain refers
    bool operator==(const Exposure&) const = default;
};
/// The photo's exposure and lens.
Exposure exposure_of(const package::PhotoRecord& photo);

/// A rectangle of a frame: its upper left corner and its size, in pixels.
struct Area {
    double left = 0, top = 0, width = 0, height = 0;
    bool operator==(const Area&) const = default;
};

/// A camera from which to render. Positions are relative to the package's origin.
struct View {
    Intrinsics intrinsics;
    Pose cam_from_origin;
    Exposure exposure{};
    /// 0: perspective. Otherwise orthographic: points are projected along the camera's axis, at the scale
    /// that a perspective view has at this depth. The eye is placed so far away that directions and levels of
    /// detail computed as in perspective are accurate to 1 / orthographic_distance.
    double orthographic_depth = 0;
};

/// The size of a view's picture.
inline FrameSize frame_size(const View& view) { return {view.intrinsics.width, view.intrinsics.height}; }

/// The view enlarged by this many pixels on each side.
inline View widened(View view, int pixels) {
    view.intrinsics.width += 2 * pixels;
    view.intrinsics.height += 2 * pixels;
    view.intrinsics.cx += pixels;
    view.intrinsics.cy += pixels;
    return view;
}

/// Whether two views are equal, apart from their exposure.
bool same_view(const View& a, const View& b);
inline bool operator==(const View& a, const View& b) { return same_view(a, b) && a.exposure == b.exposure; }

/// The distance of an orthographic view's eye from the model, as a multiple of the model's size.
inline constexpr double orthographic_distance = 1e6;

/// An orthographic view with `middle` at pixel (0, 0) and `pixels` per unit. `right` and `down`, which are
/// perpendicular unit vectors, point along its rows and columns. `size`: an upper limit for the size of the
/// model, such as the diagonal of its bounds. Throws Error(usage) if a number is not finite or not positive.
View orthographic_view(const Eigen::Vector3d& middle, const Eigen::Vector3d& right,
                       const Eigen::Vector3d& down, double pixels, double size, FrameSize frame);

/// The orthographic view with the scale of a perspective view at `depth` in front of its eye. `size` and
/// errors are as in orthographic_view().
View orthographic(View perspective, double depth, double size);

/// The reference length for relative tolerances: the approximate size of an orthographic view's content, or
/// the depth `z` in a perspective view.
double scale_at(const View& view, double z);

/// The depth of a point along a view's axis.
double depth_in(const View& view, const Eigen::Vector3d& point);

/// The matrix from the origin's coordinates to clip space for a view and depths from range.x() to range.y(),
/// like clip_from_cam().
Eigen::Matrix4d clip_from_origin(const View& view, const Eigen::Vector2d& range);

/// The photo's own camera and exposure; the frame is `scale` times the photo's size (rounded, at least one
/// pixel).
View view_of_photo(const package::PhotoRecord& photo, double scale);

/// A view from `eye` toward `target`, both relative to the origin, with `up` at the top, or any direction if
/// the view is along `up`. The vertical field of view is in degrees. Throws Error(usage) if eye and target
/// coincide or their distance is not finite.
View view_towards(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up,
                  double fov, int width, int height);

/// The rotation of a camera turned clockwise about its axis.
Eigen::Matrix3d rolled(const Eigen::Matrix3d& camera, double degrees);

/// The clockwise roll of a camera relative to view_towards(), in degrees from -180 to 180.
double roll_of(const Eigen::Matrix3d& camera, const Eigen::Vector3d& up);

/// The homography from pixels of one view to those of another from the same position.
Eigen::Matrix3d pixels_from_pixels(const Intrinsics& to, const Eigen::Matrix3d& to_R, const View& from);

}  // namespace vantage
