#include "pipeline/stages/depth_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "pipeline/pixels/simd.h"
#include "scene/quantile.h"

namespace vantage {
namespace {

struct Range {
    float least, most;
};

/// Of positive depths, without the infinite ones.
VANTAGE_SIMD Range range(const float* z, std::size_t count) {
    constexpr std::size_t lanes = 16;
    constexpr float infinite = std::numeric_limits<float>::infinity();
    float least[lanes], most[lanes]{};
    std::fill_n(least, lanes, infinite);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t l = 0; l < lanes; ++l) {
            const float v = z[i + l], finite = v < infinite ? v : 0;
            least[l] = v < least[l] ? v : least[l];
            most[l] = most[l] < finite ? finite : most[l];
        }
    for (; i < count; ++i) {
        least[0] = std::min(least[0], z[i]);
        most[0] = std::max(most[0], z[i] < infinite ? z[i] : 0);
    }
    return {*std::min_element(least, least + lanes), *std::max_element(most, most + lanes)};
}

}  // namespace

std::optional<DepthSummary> summarize_depths(std::span<const float> z) {
    const auto [least, most] = range(z.data(), z.size());
    if (most == 0) return std::nullopt;
    DepthSummary out{least, most, 0};
    std::vector<float> some;
    for (std::size_t i = 0; i < z.size(); i += z.size() / 16384 | 1)  // odd: no column of the map by itself
        if (std::isfinite(z[i])) some.push_back(z[i]);
    if (some.empty()) some.push_back(out.nearest);
    out.median = upper_median(std::span(some));
    return out;
}

}  // namespace vantage
