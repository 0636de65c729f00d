#include "pipeline/stages/coordinates/depth_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "base/values/quantile.h"
#include "base/values/simd.h"

namespace vantage {
namespace {

struct Range {
    float low, high;
};

/// Range of the finite depths; `high` is 0 if no depth is finite. Depths are positive.
VANTAGE_SIMD Range range(const float* z, std::size_t count) {
    constexpr std::size_t lanes = 16;
    constexpr float infinite = std::numeric_limits<float>::infinity();
    float low[lanes], high[lanes]{};
    std::fill_n(low, lanes, infinite);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t l = 0; l < lanes; ++l) {
            const float v = z[i + l], finite = v < infinite ? v : 0;
            low[l] = v < low[l] ? v : low[l];
            high[l] = high[l] < finite ? finite : high[l];
        }
    for (; i < count; ++i) {
        low[0] = std::min(low[0], z[i]);
        high[0] = std::max(high[0], z[i] < infinite ? z[i] : 0);
    }
    return {*std::min_element(low, low + lanes), *std::max_element(high, high + lanes)};
}

}  // namespace

std::optional<DepthSummary> summarize_depths(std::span<const float> z) {
    const auto [low, high] = range(z.data(), z.size());
    if (high == 0) return std::nullopt;
    DepthSummary out{low, high, 0};
    std::vector<float> sample;
    // The stride is odd, so that the sample is not confined to a few columns of the map.
    for (std::size_t i = 0; i < z.size(); i += z.size() / 16384 | 1)
        if (std::isfinite(z[i])) sample.push_back(z[i]);
    if (sample.empty()) sample.push_back(out.nearest);
    out.median = upper_median(std::span(sample));
    return out;
}

}  // namespace vantage
