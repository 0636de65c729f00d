#include "pipeline/stages/cut_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/values/tiling.h"

using namespace vantage;

TEST(CutTile, TilesHoldEveryTexelAndItsNeighbors) {
    const Level level{600, 300};
    std::vector<std::uint32_t> texels(std::size_t(level.width) * std::size_t(level.height));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = std::uint32_t(i);
    std::vector<std::uint32_t> stored(tile_bytes / 4);
    for (int t = 0; t < level.tiles(); ++t) {
        cut_tile(std::as_bytes(std::span(texels)), level, std::size_t(t),
                 std::as_writable_bytes(std::span(stored)));
        for (int y = 0; y < tile_size; ++y)
            for (int x = 0; x < tile_size; ++x) {
                const int u =
                    std::clamp(t % level.columns() * tile_content + x - tile_border, 0, level.width - 1);
                const int v =
                    std::clamp(t / level.columns() * tile_content + y - tile_border, 0, level.height - 1);
                ASSERT_EQ(stored[std::size_t(y) * tile_size + std::size_t(x)],
                          std::uint32_t(v * level.width + u));
            }
    }
}
