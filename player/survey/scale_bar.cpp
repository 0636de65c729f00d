#include "player/survey/scale_bar.h"

#include <algorithm>
#include <cmath>

namespace vantage {

std::optional<ScaleBar> scale_bar(const View& view, const Eigen::Vector3d& point, const Scale& scale,
                                  double pixels) {
    const double pixel = shown_length(scale) * depth_in(view, point) / view.intrinsics.fx;
    if (scale.unit == Unit::unknown || !(pixel > 0) || !std::isfinite(pixel)) return {};
    const double power = std::pow(10, std::floor(std::log10(pixels * pixel)));
    const auto differs = [&](double factor) { return std::abs(std::log(factor * power / (pixels * pixel))); };
    const double length = power * std::ranges::min({1.0, 2.0, 5.0, 10.0}, {}, differs);
    return ScaleBar{length, length / pixel};
}

}  // namespace vantage
