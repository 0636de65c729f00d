#include "player/view/turntable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/package/contents/first_photo.h"

namespace vantage {
namespace {

using std::numbers::pi;

/// The horizontal direction from the model's center to the first view; arbitrary if there are no photos.
Eigen::Vector3d side_of_first_view(const PackageReader& package, const Eigen::Vector3d& up) {
    const std::uint32_t photo = first_photo(package);
    if (photo >= package.photos().size()) return up.unitOrthogonal();
    const Eigen::Vector3d eye = cam_from_origin(package.photos()[photo]).center(),
                          level = eye - eye.dot(up) * up;
    return level.norm() > 1e-3 * eye.norm() ? level.normalized() : up.unitOrthogonal();
}

/// A cylinder whose axis passes through the origin in the up direction.
struct Cylinder {
    double radius, half_height;
};

/// The cylinder around the bounds of a scene, whose center is the origin.
Cylinder cylinder_around(const package::SceneRecord& scene, const Eigen::Vector3d& up) {
    const Eigen::Vector3d half = (Eigen::Map<const Eigen::Vector3d>(scene.bounds_max) -
                                  Eigen::Map<const Eigen::Vector3d>(scene.bounds_min)) /
                                 2;
    Cylinder out{1e-6, 1e-6};
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d c(corner & 1 ? half.x() : -half.x(), corner & 2 ? half.y() : -half.y(),
                                corner & 4 ? half.z() : -half.z());
        out.half_height = std::max(out.half_height, std::abs(c.dot(up)));
        out.radius = std::max(out.radius, (c - c.dot(up) * up).norm());
    }
    return out;
}

/// The distance at which a camera that looks down at the cylinder's center, at the angle `elevation`, sees
/// the entire cylinder. `width` and `height` are half of the frame's size at distance 1.
double distance_to_see(const Cylinder& c, double elevation, double width, double height) {
    constexpr int steps = 64;
    double distance = 0;
    for (int i = 0; i < 2 * steps; ++i) {
        // A point of a rim; its components point toward the camera, to the right, and up.
        const double angle = 2 * pi * i / steps, toward = c.radius * std::cos(angle),
                     right = c.radius * std::sin(angle), above = i < steps ? c.half_height : -c.half_height;
        const double nearer = toward * std::cos(elevation) + above * std::sin(elevation),
                     higher = above * std::cos(elevation) - toward * std::sin(elevation);
        distance = std::max({distance, nearer + std::abs(right) / width, nearer + std::abs(higher) / height});
    }
    return distance;
}

}  // namespace

Navigation framed(const PackageReader& package, double aspect) {
    constexpr double fov = 30, margin = 1.06, elevation = 20 * pi / 180;
    const Eigen::Vector3d up = up_of(package.scene());
    const double half_height = std::tan(fov / 2 * pi / 180) / margin;
    const double distance =
        distance_to_see(cylinder_around(package.scene(), up), elevation, half_height * aspect, half_height);
    const Eigen::Vector3d eye =
        distance * (std::cos(elevation) * side_of_first_view(package, up) + std::sin(elevation) * up);
    const Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    return {eye, middle, up, view_towards(eye, middle, up, fov, 1, 1).cam_from_origin.R, fov};
}

std::vector<Navigation> turntable(const Navigation& start, int count, const Arc& arc) {
    std::vector<Navigation> out;
    const double middle = (arc.from + arc.to) / 2, half = (arc.to - arc.from) / 2,
                 phase = half > 0 ? std::asin(std::clamp(-middle / half, -1.0, 1.0)) : 0;
    for (int i = 0; i < count; ++i) {
        const double share = double(i) / count;
        const double degrees = half >= 180 ? 360 * share : middle + half * std::sin(phase + 2 * pi * share);
        orbit(out.emplace_back(start), -degrees * pi / 180, 0);
    }
    return out;
}

}  // namespace vantage
