#include "player/camera/view.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "scene/error.h"
#include "scene/package_reader.h"

namespace vantage {

Exposure exposure_of(const package::PhotoRecord& photo) {
    Exposure e;
    for (std::size_t c = 0; c < 3; ++c) {
        e.gain[c] = float(1 / photo.gain[c]);
        e.falloff[c] = photo.falloff[c];
    }
    e.band = photo.band;
    return e;
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
        throw Error(Exit::usage, "a view's eye and target must differ, by a finite distance");
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

Eigen::Vector3d mean_up(std::span<const package::PhotoRecord> photos) {
    if (photos.empty()) return Eigen::Vector3d::UnitZ();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const package::PhotoRecord& p : photos) sum -= cam_from_origin(p).R.row(1).transpose();
    return sum.norm() > 1e-6 ? sum.normalized() : Eigen::Vector3d::UnitY();
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
