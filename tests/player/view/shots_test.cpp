#include "player/view/shots.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/player/test_scene.h"

using namespace vantage;

TEST(Shots, FrameOfAnotherAspectRatioHoldsTheWholePhoto) {
    const package::PhotoRecord photo = photo_at({0, 0, 0}, Eigen::Matrix3d::Identity());
    const Shot exact = photo_shot(photo, "a", std::nullopt, 0.5);
    EXPECT_EQ(exact.view.intrinsics.width, 850);
    EXPECT_DOUBLE_EQ(exact.view.intrinsics.cx, photo.cx / 2);
    const Shot framed = photo_shot(photo, "a", FrameSize{3400, 1300}, 1);
    EXPECT_DOUBLE_EQ(framed.view.intrinsics.fx, photo.fx);
    EXPECT_DOUBLE_EQ(framed.view.intrinsics.cx, photo.cx + 850);
}
