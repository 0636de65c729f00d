#include "player/interface/overlays/glide.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vantage {
namespace {

const Drags nothing{};

Drags right(double pixels) {
    Drags d{};
    d[0].right = pixels;
    return d;
}

/// A view that is dragged to the right for half a second and released.
struct Thrown {
    Glide glide;
    double now = 100, frame;

    Thrown(double pixels_per_second, double frames_per_second) : frame(1 / frames_per_second) {
        move_on(glide, nothing, true, now);
        for (const double end = now + 0.5; now < end - 1e-9;)
            move_on(glide, right(pixels_per_second * frame), true, now += frame);
    }
    /// The distance that the view moves in the next `seconds`.
    double after(double seconds) {
        double moved = 0;
        for (const double end = now + seconds; now < end - 1e-9;)
            moved += move_on(glide, nothing, false, now += frame)[0].right;
        return moved;
    }
};

TEST(Glide, WhatIsLetGoInMotionMovesOnAndComesToRest) {
    Thrown thrown(800, 60);
    const double first = thrown.after(0.25), rest = thrown.after(2);
    EXPECT_NEAR(first, 200 * (1 - std::exp(-1)), 10);
    EXPECT_NEAR(first + rest, 200, 2);
    EXPECT_EQ(thrown.after(1), 0);
}

TEST(Glide, MovesAsFarWhereFramesAreSlow) {
    EXPECT_NEAR(Thrown(800, 10).after(3), 200, 1);
    EXPECT_NEAR(Thrown(800, 240).after(3), 200, 1);
}

TEST(Glide, WhatWasHeldStillStays) {
    for (const double rate : {8.0, 60.0, 240.0}) {
        Thrown thrown(800, rate);
        for (int i = 0; i < std::max(3, int(0.05 * rate) + 1); ++i)
            EXPECT_EQ(move_on(thrown.glide, nothing, true, thrown.now += thrown.frame)[0].right, 0);
        EXPECT_EQ(thrown.after(1), 0) << rate << " frames per second";
    }
}

TEST(Glide, OneJumpIsNoMotion) {
    Glide glide;
    move_on(glide, nothing, true, 1);
    EXPECT_EQ(move_on(glide, right(60), true, 1.02)[0].right, 60);
    EXPECT_EQ(move_on(glide, nothing, false, 1.04)[0].right, 0);
}

TEST(Glide, SlowMovementsAreExact) { EXPECT_EQ(Thrown(40, 60).after(1), 0); }

TEST(Glide, IsStoppedByHolding) {
    Thrown thrown(800, 60);
    EXPECT_GT(thrown.after(0.1), 0);
    EXPECT_EQ(move_on(thrown.glide, nothing, true, thrown.now += thrown.frame)[0].right, 0);
    EXPECT_EQ(thrown.after(1), 0);
}

TEST(Glide, FramesAtOneTimeMoveNothing) {
    Glide glide;
    for (int i = 0; i < 5; ++i) move_on(glide, right(10), true, 1);
    EXPECT_EQ(move_on(glide, nothing, false, 1)[0].right, 0);
}

}  // namespace
}  // namespace vantage
