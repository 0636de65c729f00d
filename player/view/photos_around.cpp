#include "player/view/photos_around.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/package/package_reader.h"

namespace vantage {

std::vector<std::uint32_t> photos_around(std::span<const package::PhotoRecord> photos,
                                         const Eigen::Vector3d& up) {
    const Eigen::Vector3d axis = up.normalized(), east = axis.unitOrthogonal(), north = axis.cross(east);
    std::vector<double> turn;
    for (const package::PhotoRecord& p : photos) {
        const Eigen::Vector3d at = cam_from_origin(p).center();
        const double angle = std::atan2(at.dot(north), at.dot(east));
        turn.push_back(std::isfinite(angle) ? angle : 0);
    }
    std::vector<std::uint32_t> order(photos.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t p) { return turn[p]; });
    return order;
}

}  // namespace vantage
