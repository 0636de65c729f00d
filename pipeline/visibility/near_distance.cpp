#include "pipeline/visibility/near_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/values/simd.h"

namespace vantage {
namespace {

/// Distance to the nearest border pixel at or above this one in the same column, at most `none`. `before`:
/// distances of the row above.
VANTAGE_SIMD void step(const std::uint8_t* border, const std::int16_t* before, std::int16_t* to, int width,
                       std::int16_t none) {
    for (int x = 0; x < width; ++x) {
        const std::int16_t next = std::min<std::int16_t>(std::int16_t(before[x] + 1), none);
        to[x] = border[x] ? std::int16_t(0) : next;
    }
}

/// Also takes the nearest border pixel below into account.
VANTAGE_SIMD void step_back(const std::int16_t* below, std::int16_t* to, int width, std::int16_t none) {
    for (int x = 0; x < width; ++x)
        to[x] = std::min(to[x], std::min<std::int16_t>(std::int16_t(below[x] + 1), none));
}

/// Rows are processed in blocks, since many blocks have no border within reach.
constexpr std::size_t block = 128;

/// best[x] = min(best[x], squares[x + k] + k * k), for all k from -reach to reach.
VANTAGE_SIMD void widen(const std::int16_t* squares, std::int16_t* best, int width, int reach) {
    for (int k = 1; k <= reach; ++k) {
        const auto square = std::int16_t(k * k);
        for (int x = 0; x < width; ++x) {
            const std::int16_t nearer = std::min(squares[x - k], squares[x + k]);
            best[x] = std::min(best[x], std::int16_t(nearer + square));
        }
    }
}

VANTAGE_SIMD void roots(const std::int16_t* best, float* out, int width, std::int16_t beyond) {
    for (int x = 0; x < width; ++x)
        out[x] = best[x] > beyond ? std::numeric_limits<float>::infinity() : std::sqrt(float(best[x]));
}

}  // namespace

std::vector<float> near_distance(const std::vector<std::uint8_t>& borders, int width, int height, int reach) {
    reach = std::clamp(reach, 0, max_near_distance);
    const auto none = std::int16_t(reach + 1);
    const auto w = std::size_t(width), h = std::size_t(height), margin = std::size_t(reach);
    std::vector<std::int16_t> column(w * h);
    const std::vector<std::int16_t> nothing(w, none);
    for (std::size_t y = 0; y < h; ++y)
        step(borders.data() + y * w, y ? &column[(y - 1) * w] : nothing.data(), &column[y * w], width, none);
    for (std::size_t y = h - 1; y-- > 0;) step_back(&column[(y + 1) * w], &column[y * w], width, none);

    std::vector<float> out(w * h, std::numeric_limits<float>::infinity());
    const auto far = std::int16_t(none * none);
    std::vector<std::int16_t> squares(w + 2 * margin, far), best(w);
    for (std::size_t y = 0; y < h; ++y) {
        const std::int16_t* row = &column[y * w];
        for (std::size_t x = 0; x < w; ++x) best[x] = squares[margin + x] = std::int16_t(row[x] * row[x]);
        for (std::size_t first = 0; first < w; first += block) {
            const std::size_t last = std::min(w, first + block);
            const auto* from = squares.data() + first;  // a margin before the block
            if (*std::min_element(from, from + (last - first) + 2 * margin) == far) continue;
            widen(&squares[margin + first], &best[first], int(last - first), reach);
            roots(&best[first], &out[y * w + first], int(last - first), std::int16_t(reach * reach));
        }
    }
    return out;
}

}  // namespace vantage
