#include "player/render/timing/frame_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vantage {

FrameStatistics frame_statistics(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto rank = [&](double share) {
        const double at = std::ceil(share * double(values.size())) - 1;
        return values[std::size_t(std::clamp(at, 0.0, double(values.size() - 1)))];
    };
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {sum / double(values.size()), rank(0.5), rank(0.99), rank(0.999), values.back()};
}

}  // namespace vantage
