#include "base/files/side_by_side.h"

#include <algorithm>
#include <cstdlib>

namespace vantage {

std::vector<std::uint8_t> side_by_side(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b,
                                       std::size_t width) {
    std::vector<std::uint8_t> out(3 * a.size(), 255);
    for (std::size_t p = 0; p < a.size() / 4; ++p) {
        const std::size_t to = 4 * ((p / width) * 3 * width + p % width);
        for (std::size_t c = 0; c < 4; ++c) {
            const int x = a[4 * p + c], y = b[4 * p + c];
            out[to + c] = std::uint8_t(x);
            out[to + 4 * width + c] = std::uint8_t(y);
            if (c < 3) out[to + 8 * width + c] = std::uint8_t(std::min(255, shown_gain * std::abs(x - y)));
        }
    }
    return out;
}

}  // namespace vantage
