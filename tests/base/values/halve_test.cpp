#include "base/values/halve.h"

#include <gtest/gtest.h>

using namespace vantage;

TEST(Halve, AveragesLinearLightAndRepeatsOddEdges) {
    const RgbaImage image{3, 1, {0, 0, 0, 255, 255, 255, 255, 255, 90, 90, 90, 255}};
    const RgbaImage half = halve(image);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_NEAR(half.rgba[0], 188, 1);  // half the light of white, in sRGB
    EXPECT_NEAR(half.rgba[4], 90, 1);
}

TEST(Halve, TransparentTexelsContributeNoColor) {
    const RgbaImage half = halve(RgbaImage{2, 1, {200, 100, 50, 255, 0, 0, 0, 0}});
    EXPECT_NEAR(half.rgba[0], 200, 1);
    EXPECT_NEAR(half.rgba[1], 100, 1);
    EXPECT_EQ(half.rgba[3], 128);
}
