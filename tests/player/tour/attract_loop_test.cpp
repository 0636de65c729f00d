#include "player/tour/attract_loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/text/error.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

const InputAxes axes{Vector3d::Zero(), Vector3d::UnitZ()};

Story told() {
    Story story;
    story.notes = {{"clock", {}, {}, "", StoryView{{0, -4, 1}, {0, 0, 1}}, {}},
                   {"door", {}, {}, "", StoryView{{3, 0, 1}, {0, 0, 1}}, {}},
                   {"sign", {}, {}}};
    story.tours = {{"short", {}, {{"clock", {}, 2, 1}, {"door", {}, 4, 3}}}};
    return story;
}

Navigation home() { return camera_at({{0, -5, 2}, {0, 0, 1}}, axes); }

}  // namespace

TEST(AttractLoop, IsNothingUnlessTheStorySaysSo) {
    EXPECT_FALSE(attract_loop(told(), home(), axes, "s.json"));
}

TEST(AttractLoop, TurnsOnceAroundWhatTheFirstViewShows) {
    Story story = told();
    story.attract = StoryAttract{.turn = 90};
    const auto loop = attract_loop(story, home(), axes, "s.json");
    ASSERT_TRUE(loop);
    EXPECT_EQ(loop->seconds, 90);
    EXPECT_EQ(loop->begin().eye, home().eye);
    EXPECT_EQ(loop->positions.back().eye, home().eye) << "the loop must repeat without a jump";
    double turned = 0;
    for (std::size_t i = 1; i < loop->positions.size(); ++i) {
        const Vector3d a = loop->positions[i - 1].eye, b = loop->positions[i].eye;
        EXPECT_NEAR((b - home().target).norm(), (home().eye - home().target).norm(), 1e-9);
        turned += std::abs(std::remainder(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()), 2 * M_PI));
    }
    EXPECT_NEAR(turned, 2 * M_PI, 1e-6);
}

TEST(AttractLoop, FollowsATourOrStopsOfItsOwn) {
    Story story = told();
    story.attract = StoryAttract{.tour = "short"};
    const auto tour = attract_loop(story, home(), axes, "s.json");
    ASSERT_TRUE(tour);
    EXPECT_NEAR(tour->seconds, 1 + 4 + 3, 1e-9) << "the flight begins at the first stop";
    EXPECT_LT((tour->begin().eye - Vector3d(0, -4, 1)).norm(), 1e-9);
    EXPECT_LT((tour->along->at(8).eye - Vector3d(3, 0, 1)).norm(), 1e-9);
    story.attract = StoryAttract{.stops = {{"door", {}, 2, 5}}};
    const auto stops = attract_loop(story, home(), axes, "s.json");
    ASSERT_TRUE(stops);
    EXPECT_LT((stops->begin().eye - Vector3d(3, 0, 1)).norm(), 1e-9);
    story.attract->stops = {{"sign", {}, 2, 5}};
    EXPECT_THROW(attract_loop(story, home(), axes, "s.json"), Error) << "a note without a view";
}
