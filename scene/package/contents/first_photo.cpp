#include "scene/package/contents/first_photo.h"

#include <limits>

namespace vantage {

std::uint32_t first_photo(const PackageReader& package, std::uint32_t image_set) {
    const auto photos = package.photos();
    const std::uint64_t first = package.scene().first_photo;
    auto best = std::uint32_t(photos.size());
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p < photos.size(); ++p) {
        if (photos[p].image_set != image_set || !photos[p].levels) continue;
        const double away =
            first >= photos.size()
                ? p
                : (cam_from_origin(photos[p]).center() - cam_from_origin(photos[first]).center()).norm();
        if (p == first) return p;
        if (away < nearest) best = p, nearest = away;
    }
    return best;
}

}  // namespace vantage
