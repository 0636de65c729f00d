#include "player/view/photo_directions.h"

#include <algorithm>
#include <limits>

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

}  // namespace vantage
