#include "pipeline/pixels/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scene/halve.h"
#include "scene/tiling.h"

using namespace vantage;

TEST(Pyramid, TilesHoldEveryTexelAndItsNeighbors) {
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

TEST(Pyramid, HalvingAveragesLinearLightAndRepeatsOddEdges) {
    const RgbaImage image{3, 1, {0, 0, 0, 255, 255, 255, 255, 255, 90, 90, 90, 255}};
    const RgbaImage half = halve(image);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_NEAR(half.rgba[0], 188, 1);  // half the light of white, in sRGB
    EXPECT_NEAR(half.rgba[4], 90, 1);
}

TEST(Pyramid, TransparentTexelsContributeNoColor) {
    const RgbaImage half = halve(RgbaImage{2, 1, {200, 100, 50, 255, 0, 0, 0, 0}});
    EXPECT_NEAR(half.rgba[0], 200, 1);
    EXPECT_NEAR(half.rgba[1], 100, 1);
    EXPECT_EQ(half.rgba[3], 128);
}
