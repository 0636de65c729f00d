#include "player/camera/turntable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vantage {
namespace {

constexpr double pi = std::numbers::pi;

/// The horizontal direction, from the middle of the model, in which most cameras are.
Eigen::Vector3d side_of_photos(const PackageReader& package, const Eigen::Vector3d& up) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const package::PhotoRecord& p : package.photos()) sum += cam_from_origin(p).center().normalized();
    sum -= sum.dot(up) * up;
    return sum.norm() > 1e-3 ? sum.normalized() : up.unitOrthogonal();
}

}  // namespace

Navigation framed(const PackageReader& package, double aspect) {
    constexpr double fov = 30, margin = 1.05, elevation = 20 * pi / 180;
    const package::SceneRecord& scene = package.scene();
    const Eigen::Vector3d up = mean_up(package.photos());
    const double radius = std::max((Eigen::Map<const Eigen::Vector3d>(scene.bounds_max) -
                                    Eigen::Map<const Eigen::Vector3d>(scene.bounds_min))
                                           .norm() /
                                       2,
                                   1e-6);
    const double half_height = std::tan(fov / 2 * pi / 180),
                 narrower = std::atan(half_height * std::min(1.0, aspect));
    const Eigen::Vector3d eye =
        (std::cos(elevation) * side_of_photos(package, up) + std::sin(elevation) * up) * radius * margin /
        std::sin(narrower);
    const Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    return {eye, middle, up, view_towards(eye, middle, up, fov, 1, 1).cam_from_origin.R, fov};
}

std::vector<Navigation> turntable(const Navigation& start, int count, double arc) {
    std::vector<Navigation> out;
    for (int i = 0; i < count; ++i) {
        const double share = double(i) / count;
        const double degrees = arc >= 360 ? 360 * share : arc / 2 * std::sin(2 * pi * share);
        orbit(out.emplace_back(start), -degrees * pi / 180, 0);
    }
    return out;
}

}  // namespace vantage
