#include "player/camera/navigation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/player/test_scene.h"

using namespace vantage;

TEST(Navigation, StandsAtThePhotosCamera) {
    Random random;
    const View v = random_view(random);
    const package::PhotoRecord photo = photo_at(v.cam_from_origin.center(), v.cam_from_origin.R);
    const Navigation n = stand_at(photo, {0, 0, 1});
    EXPECT_TRUE(view_of(n, 100, 100).cam_from_origin.R.isApprox(v.cam_from_origin.R, 1e-12));
    EXPECT_NEAR((n.target - n.eye).norm(), photo.seen_distance, 1e-9);
}

TEST(Navigation, OrbitKeepsDistanceAndStopsAtThePoles) {
    Random random;
    const View v = random_view(random);
    Navigation n = stand_at(photo_at(v.cam_from_origin.center(), v.cam_from_origin.R), {0, 0, 1});
    const double distance = (n.eye - n.target).norm();
    for (int i = 0; i < 500; ++i) {
        orbit(n, random(-1, 1), random(-2, 1));
        EXPECT_NEAR((n.eye - n.target).norm(), distance, 1e-6);
        EXPECT_TRUE((n.R * n.R.transpose()).isIdentity(1e-6));
        EXPECT_LT((n.target - n.eye).normalized().cross(Eigen::Vector3d(n.R.row(2))).norm(), 1e-6);
        EXPECT_LT(std::abs(n.R.row(2).dot(n.up)), 0.99999) << "beyond a pole, left and right are swapped";
    }
}
