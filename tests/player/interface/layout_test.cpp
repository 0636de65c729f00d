#include "player/interface/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

using namespace vantage;

namespace {

bool overlap(const Area& a, const Area& b) {
    return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
           b.top < a.top + a.height;
}

}  // namespace

TEST(Layout, NothingCoversThePictureAndNothingIsOutsideTheWindow) {
    const std::tuple<int, int, double> windows[] = {{320, 240, 14},   {600, 420, 14},   {800, 600, 14},
                                                    {1920, 1080, 14}, {3840, 2160, 21}, {600, 900, 14}};
    for (const auto& [width, height, em] : windows)
        for (const bool expert : {false, true})
            for (const bool photos : {false, true}) {
                Panels panels;
                panels.expert = expert;
                const Layout l = layout_of(panels, width, height, em, photos);
                SCOPED_TRACE(testing::Message() << width << " x " << height << ", expert " << expert);
                const Area parts[] = {l.menu, l.sidebar, l.strip, l.bar, l.free};
                double covered = 0;
                for (const Area& a : parts) {
                    EXPECT_GE(std::min({a.left, a.top, a.width, a.height}), 0);
                    EXPECT_LE(a.left + a.width, width);
                    EXPECT_LE(a.top + a.height, height);
                    covered += a.width * a.height;
                    for (const Area& b : parts) EXPECT_TRUE(&a == &b || !overlap(a, b));
                }
                EXPECT_NEAR(covered, double(width) * height, 1) << "the areas do not add up to the window";
                EXPECT_GT(l.free.width * l.free.height, 0.3 * width * height)
                    << "too little space for the picture";
                EXPECT_EQ(l.strip.height > 0, photos && height > 24 * em);
            }
}
