#include "tests/bench/scenes/crop.h"

#include <algorithm>
#include <cstddef>

namespace vantage::bench {

const std::uint8_t* texel(const Picture& p, int x, int y) {
    return p.rgba.data() + 4 * (std::size_t(y) * std::size_t(p.width) + std::size_t(x));
}

Picture crop(const Picture& p, int x0, int y0, int width, int height) {
    Picture out{width, height, {}, {}};
    out.rgba.reserve(4 * std::size_t(width) * std::size_t(height));
    for (int y = y0; y < y0 + height; ++y)
        for (int x = x0; x < x0 + width; ++x) {
            const std::uint8_t* t = texel(p, std::clamp(x, 0, p.width - 1), std::clamp(y, 0, p.height - 1));
            out.rgba.insert(out.rgba.end(), t, t + 4);
        }
    return out;
}

}  // namespace vantage::bench
