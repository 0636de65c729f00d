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
                panels.measure = true;
                const Layout beside = layout_of(panels, width, height, em, photos);
                const double column = l.free.width - beside.free.width;
                EXPECT_TRUE(column == 0 || (column > 20 * em && beside.free.width >= 40 * em)) << column;
                EXPECT_EQ(column > 0, l.free.width >= 66 * em);
            }
}

TEST(PictureArea, IsAtItsAimLongBeforeTheEndOfATour) {
    Layout panels, none;
    panels.free = {0, 0, 1280, 600}, none.free = {0, 0, 1280, 800};
    PictureArea area;
    area.update(panels, Compare::nothing, {1280, 800}, {}, 0);
    double last = 600, now = 100;
    for (int frame = 0; frame < 10; ++frame, now += 0.2) {  // a slow computer
        const double high = area.update(none, Compare::nothing, {1280, 800}, 160, now).height;
        EXPECT_GE(high, last);
        EXPECT_TRUE(frame > 0 || high < 700) << "no jump";
        last = high;
    }
    EXPECT_EQ(last, 800) << "otherwise the view would move on, and its picture would remain coarse";
}
