#include "tests/bench/sweeps/tiles/tile_pixels.h"

#include "tests/bench/scenes/evenly_spread.h"

namespace vantage::bench {

std::vector<std::uint32_t> some_photos(const PackageReader& package, std::size_t count) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < package.photos().size(); ++i)
        if (package.photos()[i].levels > 0) all.push_back(i);
    return evenly_spread(all, count);
}

}  // namespace vantage::bench
