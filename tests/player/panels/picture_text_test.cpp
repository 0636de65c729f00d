#include "player/panels/picture_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

using namespace vantage;

TEST(PictureText, FillsItsLineWithLettersAndNothingElse) {
    const PictureText text(26);
    const std::string words = "Größe 0.5";
    const int width = text.width(words);
    EXPECT_GT(width, 26);
    EXPECT_LT(text.width("Größe 0"), width);
    EXPECT_LT(text.width("ö"), text.width("oo")) << "a letter that has two bytes";
    std::set<std::pair<int, int>> pixels;
    int darkest = 0;
    text.draw(words, 100, 50, [&](int x, int y, std::uint8_t covered) {
        EXPECT_GE(x, 99);
        EXPECT_LE(x, 101 + width);
        EXPECT_GE(y, 50);
        EXPECT_LT(y, 50 + text.line());
        pixels.emplace(x, y);
        darkest = std::max(darkest, int(covered));
    });
    EXPECT_EQ(darkest, 255);
    EXPECT_GT(pixels.size(), std::size_t(26 * width / 10)) << "letters cover more than a tenth of the line";
    EXPECT_LT(pixels.size(), std::size_t(26 * width / 2));
    std::size_t nothing = 0;
    text.draw(" ", 0, 0, [&](int, int, std::uint8_t) { ++nothing; });
    text.draw("", 0, 0, [&](int, int, std::uint8_t) { ++nothing; });
    EXPECT_EQ(nothing, 0u);
}
