#include "tests/bench/sweeps/tiles/tile_pixels.h"

#include <cstring>

namespace vantage::bench {

std::vector<std::uint32_t> some_photos(const PackageReader& package, std::size_t count) {
    std::vector<std::uint32_t> all, out;
    for (std::uint32_t i = 0; i < package.photos().size(); ++i)
        if (package.photos()[i].levels > 0) all.push_back(i);
    const std::size_t some = std::min(count, all.size());
    for (std::size_t i = 0; i < some; ++i) out.push_back(all[(2 * i + 1) * all.size() / (2 * some)]);
    return out;
}

Bytes cut(const Picture& image, int x0, int y0, int size) {
    Bytes out(std::size_t(size) * std::size_t(size) * 4);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::size_t from =
                std::size_t(std::clamp(y0 + y, 0, image.height - 1)) * std::size_t(image.width) +
                std::size_t(std::clamp(x0 + x, 0, image.width - 1));
            std::memcpy(&out[4 * (std::size_t(y) * std::size_t(size) + std::size_t(x))],
                        &image.rgba[4 * from], 4);
        }
    return out;
}

}  // namespace vantage::bench
