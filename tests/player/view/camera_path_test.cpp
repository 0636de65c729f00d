#include "player/view/camera_path.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/text/error.h"
#include "tests/player/test_scene.h"

using namespace vantage;

namespace {

Navigation standing_at(const Eigen::Vector3d& eye, const Eigen::Matrix3d& R) {
    return stand_at(photo_at(eye, R), {0, 0, 1});
}

double turn(const Navigation& a, const Navigation& b) {
    return Eigen::AngleAxisd(b.R * a.R.transpose()).angle();
}

}  // namespace

TEST(StepsAlongAPath, AreEqualAndMeetEveryStop) {
    const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
    // Surfaces are 10 units away, so one unit is 0.1 radians around them.
    const std::vector<Navigation> stops{standing_at({0, 0, 0}, I), standing_at({1, 0, 0}, I),
                                        standing_at({1, 3, 0}, I)};
    const std::vector<Navigation> path = in_steps(stops, 0.0101);
    ASSERT_EQ(path.size(), 10 + 30 + 1u);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        EXPECT_NEAR((path[i + 1].eye - path[i].eye).norm(), 0.1, 1e-9) << i;
    EXPECT_EQ(path[10].eye, stops[1].eye);
    EXPECT_EQ(path.back().eye, stops[2].eye);
}

TEST(StepsAlongAPath, TurningInPlaceIsDividedByItsAngle) {
    const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d R = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const std::vector<Navigation> path =
        in_steps({standing_at({0, 0, 0}, I), standing_at({0, 0, 0}, R)}, 0.0501);
    ASSERT_EQ(path.size(), 11u);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        EXPECT_NEAR(turn(path[i], path[i + 1]), 0.05, 1e-9) << i;
}

TEST(StepsAlongAPath, OneStopIsOneFrameAndTooManyAreRefused) {
    const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
    EXPECT_EQ(in_steps({}, 0.1).size(), 0u);
    EXPECT_EQ(in_steps({standing_at({0, 0, 0}, I)}, 0.1).size(), 1u);
    EXPECT_EQ(in_steps({standing_at({0, 0, 0}, I), standing_at({0, 0, 0}, I)}, 0.1).size(), 2u);
    EXPECT_THROW(in_steps({standing_at({0, 0, 0}, I), standing_at({1e9, 0, 0}, I)}, 0.01), Error);
}
