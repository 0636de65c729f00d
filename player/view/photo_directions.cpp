#include "player/view/photo_directions.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "base/values/angle_between.h"
#include "scene/package/package_reader.h"

namespace vantage {

double angle_from_photos(std::span<const package::PhotoRecord> photos, const Eigen::Vector3d& direction) {
    constexpr double none = std::numeric_limits<double>::infinity();
    double closest = none;
    for (const package::PhotoRecord& p : photos)
        if (p.levels > 0)
            closest = std::min(closest, angle_between(cam_from_origin(p).direction(), direction));
    return closest < none ? closest : 0;
}

Arc arc_near_photos(std::span<const package::PhotoRecord> photos, const Navigation& camera) {
    constexpr double step = 1, margin = 0.01;  // degrees, radians
    const auto angle_at = [&](double degrees) {
        Navigation n = camera;
        orbit(n, -degrees * std::numbers::pi / 180, 0);
        return angle_from_photos(photos, n.R.row(2).transpose());
    };
    const double most = std::max(free_angle, angle_at(0) + margin);
    const auto reach = [&](double sign) {
        double degrees = 0;
        while (degrees < 360 && angle_at(sign * (degrees + step)) <= most) degrees += step;
        return degrees;
    };
    const double to = reach(1);
    return to < 360 ? Arc{-reach(-1), to} : Arc{};
}

}  // namespace vantage
