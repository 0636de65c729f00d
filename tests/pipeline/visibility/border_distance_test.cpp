#include "pipeline/visibility/border_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/gl/context.h"
#include "pipeline/run/settings.h"
#include "pipeline/stages/borders.h"
#include "pipeline/visibility/near_distance.h"

using namespace vantage;

namespace {

std::vector<std::uint8_t> scattered(int width, int height, int every) {
    std::mt19937 random(7);
    std::vector<std::uint8_t> borders(std::size_t(width) * std::size_t(height), 0);
    for (std::size_t i = 0; i < borders.size() / std::size_t(every); ++i)
        borders[random() % borders.size()] = 1;
    return borders;
}

std::vector<float> brute_force(const std::vector<std::uint8_t>& borders, int width, int height) {
    std::vector<float> d(borders.size(), std::numeric_limits<float>::infinity());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int v = 0; v < height; ++v)
                for (int u = 0; u < width; ++u)
                    if (borders[std::size_t(v * width + u)]) {
                        float& at = d[std::size_t(y * width + x)];
                        at = std::min(at, std::hypot(float(u - x), float(v - y)));
                    }
    return d;
}

}  // namespace

TEST(BorderDistance, ExactMatchesBruteForce) {
    const auto borders = scattered(61, 47, 150);
    const auto exact = exact_distance(borders, 61, 47), truth = brute_force(borders, 61, 47);
    for (std::size_t i = 0; i < truth.size(); ++i) ASSERT_NEAR(exact[i], truth[i], 1e-3) << i;
}

TEST(BorderDistance, NearMatchesBruteForceWithinItsReach) {
    for (const auto& [width, height] : {std::pair(61, 47), {1, 90}, {90, 1}, {1, 1}, {33, 3}})
        for (const int reach : {0, 1, 7, max_near_distance}) {
            const auto borders = scattered(width, height, 30);
            const auto near = near_distance(borders, width, height, reach);
            const auto truth = brute_force(borders, width, height);
            for (std::size_t i = 0; i < truth.size(); ++i)
                if (truth[i] <= float(reach))
                    ASSERT_NEAR(near[i], truth[i], 1e-4)
                        << width << "x" << height << " " << reach << " " << i;
                else
                    ASSERT_TRUE(std::isinf(near[i])) << width << "x" << height << " " << reach << " " << i;
        }
}

TEST(BorderDistance, JumpFloodingNeverUnderestimatesAndIsRarelyWrong) {
    const gl::HeadlessContext context(gl::Debug::on);
    const gl::Program jump_flood = jump_flood_program();
    const auto borders = scattered(203, 119, 400);
    const auto exact = exact_distance(borders, 203, 119);
    const auto flooded = flood_distance(jump_flood, borders, 203, 119);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        ASSERT_GE(flooded[i], exact[i] - 1e-3f);
        wrong += flooded[i] > exact[i] + 1e-3f;
    }
    EXPECT_LT(double(wrong) / double(exact.size()), 0.01);
}

TEST(BorderDistance, NoBorderAndOnlyBorderAreDefined) {
    const gl::HeadlessContext context(gl::Debug::on);
    const gl::Program jump_flood = jump_flood_program();
    const std::vector<std::uint8_t> none(64, 0), all(64, 1);
    for (const float d : exact_distance(none, 8, 8)) EXPECT_TRUE(std::isinf(d));
    for (const float d : flood_distance(jump_flood, none, 8, 8)) EXPECT_TRUE(std::isinf(d));
    for (const float d : exact_distance(all, 8, 8)) EXPECT_EQ(d, 0);
    for (const float d : flood_distance(jump_flood, all, 8, 8)) EXPECT_EQ(d, 0);
    const auto weights = border_weights(exact_distance(none, 8, 8), 8, 8, 2);
    EXPECT_EQ(weights[0], std::lround(255 * 0.25));  // half a pixel from the outline
    EXPECT_EQ(weights[3 * 8 + 3], 255);
}
