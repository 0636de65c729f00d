#include "player/render/timing/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/simulated_pace.h"

using namespace vantage;

namespace {

constexpr double headset_ms = 1000.0 / 90;
constexpr std::size_t found = 30;  ///< frames passed until the pace was found

/// Motions on machines that are fast enough for full resolution and on slower machines. Frame times are known
/// at the next frame or later.
std::vector<PacedMotion> motions(const std::function<double(int)>& load) {
    std::vector<PacedMotion> out;
    for (const double full : {4.0, 7.0, 14.0, 40.0})
        for (const int delay : {0, 1, 2}) out.push_back({{1, full}, headset_ms, delay, load});
    return out;
}
std::string text_of(const PacedMotion& m) {
    return std::to_string(m.machine.full) + " ms per full frame, known " + std::to_string(m.delay) + " late";
}

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
    EXPECT_EQ(next_pace(pace, fast.time(pace), goal), Pace{}) << "a fast machine draws at full resolution";
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

TEST(Pacing, OfASteadyMotionKeepsItsResolution) {
    for (const PacedMotion& m : motions({})) {
        const auto frames = paced(m);
        EXPECT_LT(count_changes(frames, found), frames.size() / 20) << text_of(m);
        EXPECT_LT(count_missed(frames, found), frames.size() / 100) << text_of(m);
    }
}

TEST(Pacing, MissesOnlyFramesThatCouldNotKnowThatAllTakeLonger) {
    for (const PacedMotion& m : motions(step_load)) {
        const auto frames = paced(m);
        EXPECT_LE(longest_missed(frames, found), m.delay + 1) << text_of(m);
        EXPECT_LT(count_missed(frames, found), frames.size() / 100) << text_of(m);
        EXPECT_NE(frames[499].pace, Pace{}) << "quality is reduced under load";
        EXPECT_GT(frames[560].pace.scale, frames[199].pace.scale - 0.1) << "quality recovers " << text_of(m);
    }
}

TEST(Pacing, BlendsAllPhotosAgainWhenALoadHasPassed) {
    for (const double full : {4.0, 8.0, 14.0, 18.0})
        for (const int delay : {0, 1, 2}) {
            const auto frames = paced({{1, full}, headset_ms, delay, step_load});
            ASSERT_FALSE(frames[199].pace.reduced) << full;
            EXPECT_FALSE(frames.back().pace.reduced) << full << " ms, known " << delay << " late";
            EXPECT_LT(count_changes(frames, 560), 20u) << "does not oscillate";
        }
}

TEST(Pacing, ReturnsAtOnceIfASingleFrameWasLate) {
    for (const PacedMotion& m : motions(spike_load)) {
        const auto frames = paced(m);
        EXPECT_EQ(longest_missed(frames, found), 1) << text_of(m);
        for (std::size_t late = 299; late + 10 < frames.size(); late += 150)
            EXPECT_NEAR(frames[late + std::size_t(m.delay) + 3].pace.scale, frames[late - 1].pace.scale, 0.08)
                << text_of(m);
    }
}

TEST(Pacing, FollowsWhatChangesSlowly) {
    for (const PacedMotion& m : motions(drift_load)) {
        const auto frames = paced(m);
        EXPECT_LE(longest_missed(frames, found), m.delay + 1) << text_of(m);
        EXPECT_LT(count_missed(frames, found), frames.size() / 50) << text_of(m);
        EXPECT_GT(frames.back().pace.scale, frames[90].pace.scale - 0.1) << text_of(m);
    }
}
