#include "player/render/pace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace vantage;

namespace {

/// A renderer whose frames take a time of their own, and one for each pixel and photo.
struct Machine {
    double fixed, full;  ///< ms; `full` at full size with all photos
    double time(const Pace& p) const { return fixed + full * p.scale * p.scale * (p.swift ? 0.4 : 1); }
};

}  // namespace

TEST(Pace, IsFoundWithinAFewFramesAndKept) {
    const double goal = 1000.0 / 15;
    for (const Machine m : {Machine{5, 20}, Machine{5, 200}, Machine{20, 1000}, Machine{30, 3000}}) {
        Pace pace = first_pace(m.time({}), goal);
        for (int frame = 0; frame < 200; ++frame) {
            EXPECT_LT(m.time(pace), 1.3 * goal)
                << "frame " << frame << ", " << m.full << " ms per full frame";
            pace = next_pace(pace, m.time(pace), goal);
        }
        EXPECT_GT(m.time(pace), std::min(0.6 * goal, 0.9 * m.time({}))) << "coarser than necessary";
    }
}

TEST(Pace, FollowsAMachineThatSlowsDownAndRecovers) {
    const double goal = 1000.0 / 30;
    Pace pace;
    const Machine fast{2, 10}, slow{2, 300};
    EXPECT_EQ(next_pace(pace, fast.time(pace), goal), Pace{}) << "a fast machine draws in full";
    for (int frame = 0; frame < 4; ++frame) pace = next_pace(pace, slow.time(pace), goal);
    EXPECT_LT(slow.time(pace), 1.1 * goal);
    for (int frame = 0; frame < 60; ++frame) pace = next_pace(pace, fast.time(pace), goal);
    EXPECT_EQ(pace, Pace{});
}

TEST(Pace, StaysWithinItsBounds) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    const Pace pace{0.5, true};
    for (const double ms : {0.0, -1.0, nan, inf}) EXPECT_EQ(next_pace(pace, ms, 30), pace);
    for (const double goal : {0.0, -1.0, nan}) EXPECT_EQ(next_pace(pace, 30, goal), pace);
    EXPECT_EQ(next_pace(pace, 1e300, 1e-300).scale, least_scale);
    EXPECT_EQ(next_pace({1, false}, 1e-300, 1e300).scale, 1);
    EXPECT_EQ(next_pace({least_scale, true}, 1e9, 1).scale, least_scale);
}

TEST(Pace, AScaledViewShowsTheSame) {
    View view;
    view.intrinsics = {1280, 720, 900, 900, 640, 360};
    const View half = scaled(view, 0.5), least = scaled(view, 1e-9);
    EXPECT_EQ(half.intrinsics.width, 640);
    EXPECT_EQ(half.intrinsics.height, 360);
    EXPECT_DOUBLE_EQ(half.intrinsics.fx / half.intrinsics.width, view.intrinsics.fx / view.intrinsics.width);
    EXPECT_EQ(least.intrinsics.width, 1) << "never empty";
    EXPECT_EQ(scaled(view, 1).intrinsics.width, 1280);
}
