#include "scene/package/contents/color_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace vantage;

namespace {

/// CIE 1976 lightness, 0 to 100.
double lightness(const std::array<std::uint8_t, 4>& code) {
    const auto linear = [](double c) {
        c /= 255;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(code[0]) + 0.7152 * linear(code[1]) + 0.0722 * linear(code[2]);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

}  // namespace

TEST(ColorMap, SequentialMapsGetEvenlyLighter) {
    for (const ColorMap map : {ColorMap::viridis, ColorMap::magma, ColorMap::cividis}) {
        const ColorTable table = color_table(map);
        const double first = lightness(table.front()), last = lightness(table.back());
        EXPECT_GT(last - first, 70) << name_of(map);
        for (std::size_t i = 0; i < table.size(); ++i)
            EXPECT_NEAR(lightness(table[i]), first + (last - first) * double(i) / 255, 6)
                << name_of(map) << ' ' << i;
    }
}

TEST(ColorMap, TheDivergingMapIsLightestInTheMiddleAndAsDarkAtBothEnds) {
    const ColorTable table = color_table(ColorMap::coolwarm);
    EXPECT_NEAR(lightness(table.front()), lightness(table.back()), 5);
    for (std::size_t i = 1; i < 128; ++i) {
        EXPECT_GE(lightness(table[i]), lightness(table[i - 1]) - 0.5) << i;
        EXPECT_LE(lightness(table[128 + i]), lightness(table[127 + i]) + 0.5) << i;
    }
    EXPECT_GT(table.front()[2], table.front()[0]) << "low is blue";
    EXPECT_GT(table.back()[0], table.back()[2]) << "high is red";
}

TEST(ColorMap, TheDivergingMapKeepsItsCenterAndItsStrengthIfTheLimitsAreUnequal) {
    const ColorTable table = color_table(ColorMap::coolwarm, 0.2), equal = color_table(ColorMap::coolwarm);
    EXPECT_NEAR(lightness(table[51]), lightness(equal[128]), 1) << "the light center";
    EXPECT_EQ(table.back(), equal.back());
    EXPECT_NEAR(lightness(table.front()), lightness(table[102]), 5) << "as far on the other side";
    EXPECT_EQ(color_table(ColorMap::magma, 0.2), color_table(ColorMap::magma));
}

TEST(ColorMap, AutomaticDivergesForBothSigns) {
    EXPECT_EQ(chosen_map(ColorMap::automatic, -1, 2), ColorMap::coolwarm);
    EXPECT_EQ(chosen_map(ColorMap::automatic, 0, 2), ColorMap::viridis);
    EXPECT_EQ(chosen_map(ColorMap::magma, -1, 2), ColorMap::magma);
}
