#include "base/values/srgb.h"

#include <gtest/gtest.h>

using namespace vantage;

TEST(Srgb, MatchesTheStandard) {
    EXPECT_DOUBLE_EQ(linear_from_srgb(0), 0);
    EXPECT_DOUBLE_EQ(linear_from_srgb(1), 1);
    EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-8);
    EXPECT_NEAR(srgb_from_linear(0.18), 0.46135613, 1e-8);
}

TEST(Srgb, RoundTripsEveryByte) {
    const auto& linear = linear_of_srgb_byte();
    for (std::size_t i = 0; i < linear.size(); ++i) {
        EXPECT_EQ(linear[i], linear_from_srgb(double(i) / 255)) << i;
        EXPECT_EQ(std::lround(255 * srgb_from_linear(linear[i])), long(i));
    }
}
