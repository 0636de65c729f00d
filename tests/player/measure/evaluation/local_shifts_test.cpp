#include "player/measure/evaluation/local_shifts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/player/measure/waves.h"

using namespace vantage;

TEST(LocalShifts, FindsTheShiftOfEachCell) {
    const Picture photo = waves(192, 128, 4, -5), picture = waves(192, 128);
    const Plane mask = [&] {
        Plane m(192, 128);
        std::ranges::fill(m.values, 1.0f);
        return m;
    }();
    const Cells cells{192, 128};
    const auto shifts = local_shifts(luminance(photo), luminance(picture), mask);
    ASSERT_EQ(shifts.size(), cells.count());
    for (std::size_t c = 0; c < shifts.size(); ++c) {
        const Place p = cells.place(c);
        if (p.x < 16 || p.y < 16 || p.x >= 176 || p.y >= 112) continue;  // content from outside the frame
        EXPECT_EQ(shifts[c].x, -4) << c;
        EXPECT_EQ(shifts[c].y, 5) << c;
    }
    for (const PixelShift& s : local_shifts(luminance(photo), luminance(photo), mask))
        EXPECT_TRUE(s.x == 0 && s.y == 0);
}
