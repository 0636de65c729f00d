#include "pipeline/stages/weight_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace vantage;

TEST(WeightMaps, DepthHasTwelveStepsPerOctave) {
    std::vector<float> z;
    for (double exponent = -20; exponent < 20; exponent += 0.0173) z.push_back(float(std::exp2(exponent)));
    z.push_back(std::numeric_limits<float>::infinity());
    const std::vector<std::uint8_t> angle(z.size(), 77), border(z.size(), 5);
    const double focal = 2000, reference = 3000;
    const auto weight_maps = combine_weights(z, angle, border, focal, reference);
    for (std::size_t i = 0; i + 1 < z.size(); ++i) {
        const double code = std::clamp(255 + 12 * std::log2(focal / z[i] / reference), 1.0, 255.0);
        ASSERT_NEAR(weight_maps[4 * i + 1], code, 0.501) << z[i];
        ASSERT_EQ(weight_maps[4 * i], 77);
        ASSERT_EQ(weight_maps[4 * i + 2], 5);
        ASSERT_EQ(weight_maps[4 * i + 3], 255);
    }
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(weight_maps[weight_maps.size() - 4 + c], 0) << "no surface there";
}

TEST(MaskPyramid, AveragesOnlyValidTexels) {
    const float inf = std::numeric_limits<float>::infinity();
    // A map of 3x2 texels: one 2x2 block with a hole, and an odd column without a surface.
    WeightMapLevel fine{3, 2, std::vector<std::uint8_t>(24, 0), {1, 5, inf, 3, inf, inf}};
    const std::uint8_t angle[] = {10, 20, 0, 33, 0, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        fine.weights[4 * i] = angle[i];
        fine.weights[4 * i + 3] = std::isfinite(fine.z[i]) ? 255 : 0;
    }
    const WeightMapLevel coarse = halve(fine);
    ASSERT_EQ(coarse.width, 2);
    ASSERT_EQ(coarse.height, 1);
    EXPECT_EQ(coarse.z[0], 5) << "the farthest depth is kept";
    EXPECT_EQ(int(coarse.weights[0]), 21) << "the mean of the three valid texels";
    EXPECT_EQ(int(coarse.weights[3]), 255);
    EXPECT_EQ(coarse.z[1], inf);
    EXPECT_EQ(int(coarse.weights[7]), 0);
}
