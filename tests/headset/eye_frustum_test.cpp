#include "player/headset/runtime/eye_frustum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double radians_per_degree = std::numbers::pi / 180;

TEST(EyeFrustum, DirectionsAtItsBordersAreAtTheBordersOfThePicture) {
    const RoomPose pose{Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized())),
                        {0.3, 1.6, -0.2}};
    const auto eye = eye_frustum(pose, -52 * radians_per_degree, 43 * radians_per_degree,
                                 47 * radians_per_degree, -50 * radians_per_degree);
    ASSERT_TRUE(eye);
    const Stance stance = standing({}, {4, 5, 6}, {1, 2, 3}, Vector3d::UnitZ(), 25);
    const View view = view_of_eye(stance, *eye, {640, 720});
    // In the room, the eye looks along -z, and y is up. Directions correspond to the angles.
    const auto pixel = [&](double right, double up) {
        const Vector3d ahead(std::tan(right), std::tan(up), -1);
        const Vector3d at = in_scene(stance, pose.at + pose.turn * (ahead * 2.5));
        return project(view.intrinsics, view.cam_from_origin, at)->pixel;
    };
    EXPECT_LT((pixel(-52 * radians_per_degree, 47 * radians_per_degree) - Eigen::Vector2d(0, 0)).norm(),
              1e-9);
    EXPECT_LT((pixel(43 * radians_per_degree, -50 * radians_per_degree) - Eigen::Vector2d(640, 720)).norm(),
              1e-9);
    EXPECT_NEAR(depth_in(view, in_scene(stance, pose.at + pose.ahead() * 2)), 50, 1e-9);
}

TEST(EyeFrustum, ExchangedAnglesAreOrderedAndImpossibleOnesRefused) {
    const auto eye = eye_frustum({}, 43 * radians_per_degree, -52 * radians_per_degree,
                                 -50 * radians_per_degree, 47 * radians_per_degree);
    ASSERT_TRUE(eye);
    EXPECT_LT(eye->left, eye->right);
    EXPECT_LT(eye->down, eye->up);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(eye_frustum({}, nan, 1, 1, -1));
    EXPECT_FALSE(eye_frustum({}, -1, 1, 1, nan));
    EXPECT_FALSE(eye_frustum({}, -90 * radians_per_degree, 1, 1, -1));
    EXPECT_FALSE(eye_frustum({}, 0, 0, 1, -1));
    EXPECT_FALSE(eye_frustum({Eigen::Quaterniond(0, 0, 0, 0), {}}, -1, 1, 1, -1));
    EXPECT_FALSE(eye_frustum({{}, {nan, 0, 0}}, -1, 1, 1, -1));
    EXPECT_TRUE(eye_frustum({}, 10 * radians_per_degree, 50 * radians_per_degree, -5 * radians_per_degree,
                            -50 * radians_per_degree))
        << "beside its axis";
}

}  // namespace
}  // namespace vantage
