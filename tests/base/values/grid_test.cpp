#include "base/values/grid.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

using namespace vantage;

TEST(Grid, ReadsRowByRowFromTheTop) {
    std::vector<int> values(12);
    std::iota(values.begin(), values.end(), 0);
    const Grid<const int> grid{values.data(), 4, 3};
    EXPECT_EQ(grid.size(), 12u);
    EXPECT_EQ(grid(0, 0), 0);
    EXPECT_EQ(grid(3, 0), 3);
    EXPECT_EQ(grid(1, 2), 9);
    EXPECT_EQ(grid.row(1).size(), 4u);
    EXPECT_EQ(grid.row(1)[2], 6);
    EXPECT_EQ(grid.all().back(), 11);
}

TEST(Grid, WritesThroughToTheElements) {
    std::vector<int> values(6);
    const Grid<int> grid{values.data(), 3, 2};
    grid(2, 1) = 7;
    grid.row(0)[1] = 5;
    EXPECT_EQ(values, (std::vector<int>{0, 5, 0, 0, 0, 7}));
}

TEST(Grid, FindsElementsBeyondTheRangeOfInt) {
    constexpr int side = 1 << 17;
    const Grid<const char> grid{nullptr, side, side};
    EXPECT_EQ(grid.size(), std::size_t(1) << 34);
}
