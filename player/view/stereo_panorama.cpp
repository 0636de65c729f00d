#include "player/view/stereo_panorama.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/text/error.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double largest_jump = 0.5;  ///< maximum jump between slices, pixels
constexpr double widest = 30;         ///< maximum width of a slice, degrees

double radians_per_column(const StereoPanorama& p) { return 2 * std::numbers::pi / p.middle.size.width; }

/// The longitude of a slice's center.
double longitude(const StereoPanorama& p, int slice) {
    return (p.columns * (slice + 0.5)) * radians_per_column(p) - std::numbers::pi;
}

}  // namespace

StereoPanorama stereo_panorama(const Panorama& middle, double eye_distance, double nearest) {
    const double most = middle.size.width * widest / 360;
    if (most < 1)
        throw Error(Exit::usage, "--panorama: a picture " + std::to_string(middle.size.width) +
                                     " pixels wide for two eyes, expected at least 12");
    // From slice to slice, an eye moves on a circle by the angle that `columns` columns cover.
    const double moves = eye_distance / 2;
    const double columns = largest_jump * nearest / std::max(moves, 1e-300);
    return {middle, eye_distance, int(std::clamp(columns, 1.0, most))};
}

int slice_count(const StereoPanorama& p) { return (p.middle.size.width + p.columns - 1) / p.columns; }

ColumnRange columns_of(const StereoPanorama& p, int slice) {
    const int first = slice * p.columns;
    return {first, std::min(p.columns, p.middle.size.width - first)};
}

std::array<Eigen::Matrix3d, slice_views> slice_axes(const StereoPanorama& p, int slice) {
    const Eigen::AngleAxisd turned(-longitude(p, slice), Vector3d::UnitY());
    const auto tilted = [&](double degrees) {
        return (Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vector3d::UnitX()) * turned)
            .toRotationMatrix();
    };
    return {tilted(-60), tilted(0), tilted(60)};
}

Eigen::Vector2d slice_half(const StereoPanorama& p) {
    return {std::tan(p.columns / 2.0 * radians_per_column(p)), std::tan(std::numbers::pi / 6)};
}

std::array<std::array<View, 2>, slice_views> eyes_of_slice(const StereoPanorama& p, int slice, double finer,
                                                           double margin) {
    const double focal = finer / radians_per_column(p);
    const Eigen::Vector2d half = slice_half(p);
    const auto pixels = [&](double tangent) {
        return 2 * int(std::ceil(focal * tangent + std::max(2.0, focal * margin)));
    };
    const int width = pixels(half.x()), height = pixels(half.y());
    const double l = longitude(p, slice);
    const Vector3d right = p.middle.R.transpose() * Vector3d(std::cos(l), 0, -std::sin(l));
    const auto axes = slice_axes(p, slice);
    std::array<std::array<View, 2>, slice_views> out;
    for (std::size_t i = 0; i < slice_views; ++i)
        for (std::size_t eye = 0; eye < 2; ++eye) {
            View& view = out[i][eye];
            view.intrinsics = {width, height, focal, focal, width / 2.0, height / 2.0};
            view.cam_from_origin.R = axes[i] * p.middle.R;
            const Vector3d at = p.middle.eye + (eye == 0 ? -0.5 : 0.5) * p.eye_distance * right;
            view.cam_from_origin.t = -view.cam_from_origin.R * at;
        }
    return out;
}

}  // namespace vantage
