#include "pipeline/stages/coordinates/depth_summary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace vantage;

TEST(DepthSummary, IgnoresInfiniteDepths) {
    std::mt19937 random(3);
    std::lognormal_distribution<float> depth(1, 0.7f);
    for (const std::size_t count : {1u, 2u, 17u, 5000u, 100000u}) {
        std::vector<float> z(count), finite;
        for (float& v : z) v = random() % 3 ? depth(random) : std::numeric_limits<float>::infinity();
        z[count / 2] = 2;
        for (const float v : z)
            if (std::isfinite(v)) finite.push_back(v);
        std::ranges::sort(finite);
        const auto found = summarize_depths(z);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->nearest, finite.front());
        EXPECT_EQ(found->farthest, finite.back());
        EXPECT_GE(found->median, finite[finite.size() * 45 / 100]);
        EXPECT_LE(found->median, finite[finite.size() * 55 / 100]);
    }
    EXPECT_FALSE(summarize_depths(std::vector<float>(9, std::numeric_limits<float>::infinity())));
    EXPECT_FALSE(summarize_depths({}));
}
