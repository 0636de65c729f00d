#include "pipeline/stages/borders.h"

#include <gtest/gtest.h>

#include "pipeline/visibility/border_distance.h"

using namespace vantage;

TEST(Borders, SlantedPlaneHasNoneAndStepHasOne) {
    DepthMap plane{40, 30, std::vector<float>(1200), {}}, step = plane;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            plane.z[std::size_t(y * 40 + x)] = 1 / (1.0f - 0.02f * float(x));  // linear in 1/z
            step.z[std::size_t(y * 40 + x)] = x < 20 ? 5.0f : 6.0f;
        }
    for (const std::uint8_t b : find_borders(plane, 0.01f)) ASSERT_EQ(b, 0);
    const auto found = find_borders(step, 0.01f);
    EXPECT_TRUE(found[15 * 40 + 19] && found[15 * 40 + 20]);
    EXPECT_FALSE(found[15 * 40 + 17] || found[15 * 40 + 22]);
}

TEST(Borders, WeightIsZeroOnABorderAndBesideIt) {
    std::vector<std::uint8_t> borders(64 * 64, 0);
    for (std::size_t y = 0; y < 64; ++y) borders[y * 64 + 20] = 1;
    const auto weights = border_weights(exact_distance(borders, 64, 64), 64, 64, 8);
    const auto at = [&](std::size_t x) { return int(weights[32 * 64 + x]); };
    EXPECT_EQ(at(20), 0);
    EXPECT_EQ(at(21), 0);
    EXPECT_EQ(at(22), 32);
    EXPECT_EQ(at(29), 255);
}
