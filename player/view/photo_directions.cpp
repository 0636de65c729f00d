#include "player/view/photo_directions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scene/package/package_reader.h"

namespace vantage {

double angle_from_photos(std::span<const package::PhotoRecord> photos, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d toward = direction.normalized();
    double closest = -2;  // cosine
    for (const package::PhotoRecord& p : photos)
        if (p.levels > 0) closest = std::max(closest, cam_from_origin(p).direction().dot(toward));
    return closest < -1.5 ? 0 : std::acos(std::clamp(closest, -1.0, 1.0));
}

}  // namespace vantage
