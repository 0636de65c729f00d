#include "player/view/view.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/text/error.h"
#include "scene/package/package_reader.h"

namespace vantage {

Exposure exposure_of(const package::PhotoRecord& photo) {
    Exposure e;
    for (std::size_t c = 0; c < 3; ++c) {
        e.gain[c] = float(1 / photo.gain[c]);
        e.vignetting[c] = photo.vignetting[c];
    }
    e.image_set = photo.image_set;
    return e;
}

bool same_view(const View& a, const View& b) {
    const Intrinsics &k = a.intrinsics, &l = b.intrinsics;
    return k.width == l.width && k.height == l.height && k.fx == l.fx && k.fy == l.fy && k.cx == l.cx &&
           k.cy == l.cy && a.cam_from_origin.R == b.cam_from_origin.R &&
           a.cam_from_origin.t == b.cam_from_origin.t && a.orthographic_depth == b.orthographic_depth;
}

View view_of_photo(const package::PhotoRecord& photo, double scale) {
    const auto size = [&](std::uint32_t n) { return std::max(1, int(std::lround(n * scale))); };
    return {intrinsics(photo).scaled(size(photo.width), size(photo.height)), cam_from_origin(photo),
            exposure_of(photo)};
}

View view_towards(const Eigen::Vector3d& eye, const Eigen::Vector3d& target, const Eigen::Vector3d& up,
                  double fov, int width, int height) {
    const Eigen::Vector3d ahead = target - eye;
    if (!std::isfinite(ahead.norm()) || !(ahead.norm() > 0))
        throw Error(Exit::usage, "a view's eye and target must differ, and their distance must be finite");
    const Eigen::Vector3d z = ahead.normalized();
    Eigen::Vector3d x = z.cross(up);
    if (x.norm() < 1e-6 * up.norm() || !(up.norm() > 0)) x = z.unitOrthogonal();
    x.normalize();
    View view;
    view.cam_from_origin.R << x.transpose(), z.cross(x).transpose(), z.transpose();
    view.cam_from_origin.t = -view.cam_from_origin.R * eye;
    const double f = height / (2 * std::tan(fov * std::numbers::pi / 360));
    view.intrinsics = {width, height, f, f, width / 2.0, height / 2.0};
    return view;
}

Eigen::Matrix3d rolled(const Eigen::Matrix3d& camera, double degrees) {
    // In a clockwise rotation, the camera's right side moves down.
    return Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Eigen::Vector3d::UnitZ()) * camera;
}

double roll_of(const Eigen::Matrix3d& camera, const Eigen::Vector3d& up) {
    const Eigen::Matrix3d level =
        view_towards({0, 0, 0}, camera.row(2).transpose(), up, 45, 1, 1).cam_from_origin.R;
    const Eigen::Vector3d right = camera.row(0);
    return std::atan2(level.row(1).dot(right), level.row(0).dot(right)) * 180 / std::numbers::pi;
}

View orthographic_view(const Eigen::Vector3d& middle, const Eigen::Vector3d& right,
                       const Eigen::Vector3d& down, double pixels, double size, FrameSize frame) {
    const double depth = orthographic_distance * size;
    if (!middle.allFinite() || !std::isfinite(pixels * depth) || !(pixels > 0) || !(size > 0))
        throw Error(Exit::usage, "an orthographic view's position, scale and size must be finite");
    View view;
    view.cam_from_origin.R << right.transpose(), down.transpose(), right.cross(down).transpose();
    view.cam_from_origin.t = Eigen::Vector3d(0, 0, depth) - view.cam_from_origin.R * middle;
    view.intrinsics = {frame.width, frame.height, pixels * depth, pixels * depth, 0, 0};
    view.orthographic_depth = depth;
    return view;
}

View orthographic(View view, double depth, double size) {
    const double far = orthographic_distance * size;
    if (!(depth > 0) || !(size > 0) || !std::isfinite(far / depth))
        throw Error(Exit::usage, "an orthographic view's position, scale and size must be finite");
    view.cam_from_origin.t.z() += far - depth;
    view.intrinsics.fx *= far / depth;
    view.intrinsics.fy *= far / depth;
    view.orthographic_depth = far;
    return view;
}

double scale_at(const View& view, double z) {
    return view.orthographic_depth > 0 ? view.orthographic_depth / orthographic_distance : z;
}

double depth_in(const View& view, const Eigen::Vector3d& point) {
    return view.cam_from_origin.R.row(2).dot(point) + view.cam_from_origin.t.z();
}

Eigen::Matrix4d clip_from_origin(const View& view, const Eigen::Vector2d& range) {
    Eigen::Matrix4d cam = Eigen::Matrix4d::Identity();
    cam.topLeftCorner<3, 3>() = view.cam_from_origin.R;
    cam.topRightCorner<3, 1>() = view.cam_from_origin.t;
    Eigen::Matrix4d clip = clip_from_cam(view.intrinsics, range.x(), range.y());
    if (view.orthographic_depth > 0) {
        // Replaces factors of 1 / z with factors of 1 / orthographic_depth.
        const double between = range.y() - range.x();
        clip.col(3).head<2>() = clip.col(2).head<2>();
        clip.topLeftCorner<2, 2>() /= view.orthographic_depth;
        clip.col(2) << 0, 0, -1 / between, 0;
        clip.col(3).tail<2>() << range.y() / between, 1;
    }
    return clip * cam;
}

Eigen::Matrix3d pixels_from_pixels(const Intrinsics& to, const Eigen::Matrix3d& to_R, const View& from) {
    const auto matrix = [](const Intrinsics& k) {
        Eigen::Matrix3d m;
        m << k.fx, 0, k.cx, 0, k.fy, k.cy, 0, 0, 1;
        return m;
    };
    return matrix(to) * to_R * from.cam_from_origin.R.transpose() * matrix(from.intrinsics).inverse();
}

}  // namespace vantage
