#include "player/measure/evaluation/relative_brightness.h"

#include <algorithm>
#include <cmath>

#include "base/values/quantile.h"
#include "base/values/srgb.h"
#include "player/measure/evaluation/place.h"

namespace vantage {
namespace {

/// Maximum distance of the quartiles from the median, as a fraction of it.
constexpr double spread = 0.5;
constexpr double darkest = 1e-3;  ///< linear light; below this value, ratios are noise

/// BT.709 luminance of linear light.
double light(const Picture& p, std::size_t pixel) {
    const auto& linear = linear_of_srgb_byte();
    return 0.2126 * linear[p.rgba[4 * pixel]] + 0.7152 * linear[p.rgba[4 * pixel + 1]] +
           0.0722 * linear[p.rgba[4 * pixel + 2]];
}

}  // namespace

bool RelativeBrightness::throughout() const {
    const double most = spread * std::abs(stops);
    return std::abs(lower - stops) <= most && std::abs(upper - stops) <= most;
}

RelativeBrightness relative_brightness(const Picture& photo, const Picture& picture,
                                       const std::vector<bool>& scored) {
    const Cells cells{photo.width, photo.height};
    std::vector<double> stops;
    for (std::size_t c = 0; c < cells.count(); ++c) {
        const Place p = cells.place(c);
        double of_photo = 0, of_picture = 0, pixels = 0;
        for (int y = p.y; y < p.y + p.height; ++y)
            for (int x = p.x; x < p.x + p.width; ++x) {
                const std::size_t i = std::size_t(y) * std::size_t(photo.width) + std::size_t(x);
                if (!scored[i]) continue;
                of_photo += light(photo, i);
                of_picture += light(picture, i);
                ++pixels;
            }
        if (2 * pixels >= p.width * p.height && std::min(of_photo, of_picture) > darkest * pixels)
            stops.push_back(std::log2(of_photo / of_picture));
    }
    return {quantile(stops, 0.5), quantile(stops, 0.25), quantile(stops, 0.75)};
}

}  // namespace vantage
