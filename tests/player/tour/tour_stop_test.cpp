#include "player/tour/tour_stop.h"

#include <gtest/gtest.h>

using namespace vantage;

TEST(TourStops, BeginWhereTheFlightToThemBegins) {
    const StoryTour tour{"a", {}, {{"", {}, 2, 5}, {"", {}, 0, 0}, {"", {}, 3, 1}}};
    const auto expect = [&](double seconds, std::size_t stop, double reached) {
        EXPECT_EQ(tour_stop(tour, seconds).stop, stop) << seconds;
        EXPECT_EQ(tour_stop(tour, seconds).reached, reached) << seconds;
    };
    expect(-1, 0, 2);
    expect(0, 0, 2);
    expect(6.9, 0, 2);
    expect(7, 2, 10);  // the stop between takes no time
    expect(11, 2, 10);
    expect(1e9, 2, 10);
}
