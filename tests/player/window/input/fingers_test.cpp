#include "player/window/input/fingers.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

using What = TouchEvent::What;

/// Finger input, processed frame by frame.
struct Watched {
    Fingers fingers;
    UserInput input;  ///< input for the next frame

    void touch(What what, std::uint32_t finger, double x, double y, double at = 0) {
        fingers.take({what, finger, x, y}, 1, at, 0, input);
    }
    void tap(double x, double y, double at) {
        touch(What::begin, 1, x, y, at);
        touch(What::end, 1, x, y, at + 0.05);
    }
    UserInput frame() {
        fingers.report(input);
        return std::exchange(input, {});
    }
};

TEST(Fingers, ATapIsAClickThatTheInterfaceSees) {
    Watched w;
    w.tap(100, 50, 0);
    const UserInput first = w.frame(), second = w.frame(), third = w.frame();
    ASSERT_EQ(first.clicks.size(), 1u);
    EXPECT_EQ(first.clicks[0].x, 100);
    ASSERT_TRUE(first.pointer && second.pointer && third.pointer);
    EXPECT_TRUE(first.pointer->down[0]);
    EXPECT_FALSE(second.pointer->down[0]);
    EXPECT_TRUE(second.pointer->there);  // a button is released on itself
    EXPECT_FALSE(third.pointer->there);  // and nothing stays highlighted under a lifted finger
}

TEST(Fingers, TwoTapsNearEachOtherAreADoubleClick) {
    Watched near, far, slow;
    near.tap(100, 50, 0), near.tap(120, 60, 0.2);
    far.tap(100, 50, 0), far.tap(200, 50, 0.2);
    slow.tap(100, 50, 0), slow.tap(100, 50, 0.9);
    EXPECT_TRUE(near.frame().double_clicked);
    EXPECT_FALSE(far.frame().double_clicked);
    EXPECT_FALSE(slow.frame().double_clicked);
}

TEST(Fingers, AFingerThatTremblesTaps) {
    Watched w;
    w.touch(What::begin, 1, 100, 50);
    w.touch(What::move, 1, 107, 46);
    w.touch(What::end, 1, 106, 47);
    const UserInput f = w.frame();
    EXPECT_EQ(f.clicks.size(), 1u);
    EXPECT_EQ(f.drags[0].right, 0);
}

TEST(Fingers, ADragQuickerThanAFrameBeginsWhereItCameDown) {
    Watched w;
    w.touch(What::begin, 1, 100, 50);
    w.touch(What::move, 1, 120, 50);
    w.touch(What::move, 1, 220, 80);
    w.touch(What::end, 1, 220, 80);
    const UserInput first = w.frame(), second = w.frame(), third = w.frame();
    EXPECT_TRUE(first.clicks.empty());
    EXPECT_TRUE(first.pointer->down[0]);
    EXPECT_EQ(first.pointer->x, 100);
    EXPECT_EQ(first.drags[0].right, 0);
    EXPECT_TRUE(second.pointer->down[0]);
    EXPECT_EQ(second.pointer->x, 220);
    EXPECT_EQ(second.drags[0].right, 100);
    EXPECT_EQ(second.drags[0].down, 30);
    EXPECT_FALSE(third.pointer->down[0]);
}

TEST(Fingers, ASecondFingerMakesItAPinchAndNoClick) {
    Watched w;
    w.touch(What::begin, 1, 100, 100);
    w.touch(What::begin, 2, 200, 100);
    w.touch(What::move, 2, 300, 100);
    UserInput f = w.frame();
    ASSERT_TRUE(f.pinch);
    EXPECT_TRUE(f.pinch_begins);
    EXPECT_EQ(f.pinch->spread, 2);
    EXPECT_EQ(f.pinch->center, Eigen::Vector2d(200, 100));
    EXPECT_FALSE(f.pointer->down[0]);
    f = w.frame();
    ASSERT_TRUE(f.pinch);  // both are still down
    EXPECT_FALSE(f.pinch_begins);
    EXPECT_EQ(f.pinch->spread, 1);
    // The remaining finger neither drags nor clicks.
    w.touch(What::end, 2, 300, 100);
    w.touch(What::move, 1, 160, 160);
    w.touch(What::end, 1, 160, 160);
    w.frame();
    f = w.frame();
    EXPECT_FALSE(f.pinch);
    EXPECT_TRUE(f.clicks.empty());
    EXPECT_EQ(f.drags[0].right, 0);
    w.tap(100, 100, 2);
    EXPECT_EQ(w.frame().clicks.size(), 1u);  // after all are lifted, a single finger acts again
}

TEST(Fingers, APinchQuickerThanAFrameIsNotLost) {
    Watched w;
    w.touch(What::begin, 1, 100, 100);
    w.touch(What::begin, 2, 200, 100);
    w.touch(What::move, 2, 300, 100);
    w.touch(What::end, 1, 100, 100);
    w.touch(What::end, 2, 300, 100);
    const UserInput f = w.frame();
    ASSERT_TRUE(f.pinch);
    EXPECT_EQ(f.pinch->spread, 2);
    EXPECT_FALSE(w.frame().pinch);
}

TEST(Fingers, ASmallTwistDoesNotTurn) {
    Watched w;
    w.touch(What::begin, 1, 100, 100);
    w.touch(What::begin, 2, 200, 100);
    w.touch(What::move, 2, 200, 110);
    EXPECT_EQ(w.frame().pinch->turned, 0);
    w.touch(What::move, 2, 200, 140);  // more than 0.2 radians in total: from here on
    EXPECT_EQ(w.frame().pinch->turned, 0);
    w.touch(What::move, 2, 200, 150);
    EXPECT_NEAR(w.frame().pinch->turned, std::atan2(50, 100) - std::atan2(40, 100), 1e-9);
}

TEST(Fingers, UnknownFingersAndAThirdOneDoNothing) {
    Watched w;
    w.touch(What::move, 9, 10, 10);
    w.touch(What::end, 9, 10, 10);
    EXPECT_FALSE(w.frame().pinch);
    w.touch(What::begin, 1, 100, 100);
    w.touch(What::begin, 2, 200, 100);
    w.touch(What::begin, 3, 500, 500);
    w.touch(What::move, 3, 700, 700);
    EXPECT_EQ(w.frame().pinch->spread, 1);
    w.touch(What::end, 1, 100, 100);  // the second and third continue
    w.touch(What::move, 3, 200, 1300);
    EXPECT_GT(w.frame().pinch->spread, 1);
}

TEST(Fingers, TheMouseTakesOver) {
    Watched w;
    w.tap(100, 100, 0);
    w.frame(), w.frame(), w.frame();
    w.fingers.leave_to_mouse();
    EXPECT_FALSE(w.frame().pointer);
}

}  // namespace
}  // namespace vantage
