#include "player/view/navigation.h"

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

TEST(Navigation, APhotoFitsIntoAFreeAreaOfAnyShape) {
    const Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    package::PhotoRecord photo = photo_at(Eigen::Vector3d(0, 0, -5), R);
    photo.width = 400, photo.height = 300, photo.fx = photo.fy = 350, photo.cx = 200, photo.cy = 150;
    const Navigation n = stand_at(photo, {0, -1, 0});
    for (const Area& free : {Area{0, 0, 800, 600}, Area{300, 20, 500, 480}, Area{0, 30, 600, 1200}}) {
        const View view = view_of(n, 900, 1400, free);
        const Eigen::Matrix3d to = pixels_from_pixels(
            view.intrinsics, R, {{400, 300, 350, 350, 200, 150}, {R, Eigen::Vector3d::Zero()}});
        const auto at = [&](double x, double y) {
            return Eigen::Vector2d((to * Eigen::Vector3d(x, y, 1)).hnormalized());
        };
        const Eigen::Vector2d low = at(0, 0), high = at(400, 300);
        EXPECT_NEAR(low.x() - free.left, free.left + free.width - high.x(), 1e-9) << "not centered";
        EXPECT_NEAR(low.y() - free.top, free.top + free.height - high.y(), 1e-9) << "not centered";
        EXPECT_NEAR(std::min(low.x() - free.left, low.y() - free.top), 0, 1e-9)
            << "the model is cropped or too small";
    }
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

namespace {

/// A point's position in the picture, in pixels.
Eigen::Vector2d shown_at(const Navigation& n, const Eigen::Vector3d& p) {
    const View view = view_of(n, 800, 600);
    const Eigen::Vector3d c = view.cam_from_origin.R * p + view.cam_from_origin.t;
    return {view.intrinsics.fx * c.x() / c.z() + view.intrinsics.cx,
            view.intrinsics.fy * c.y() / c.z() + view.intrinsics.cy};
}

Navigation before_origin() {
    Navigation n{{0, 0, -5}, {0, 0, 0}, {0, -1, 0}, Eigen::Matrix3d::Identity()};
    return n;
}

}  // namespace

/// Camera axes: x right, y down, z ahead.
TEST(Navigation, TurnsToTheSideThatIsAskedFor) {
    const auto ahead = [](const Navigation& n) { return Eigen::Vector3d(n.R.row(2)); };
    Navigation right = before_origin(), down = before_origin();
    look(right, 0.1, 0), look(down, 0, 0.1);
    EXPECT_LT((ahead(right) - Eigen::Vector3d(std::sin(0.1), 0, std::cos(0.1))).norm(), 1e-12);
    EXPECT_LT((ahead(down) - Eigen::Vector3d(0, std::sin(0.1), std::cos(0.1))).norm(), 1e-12);
    orbit(right = before_origin(), 0.1, 0), orbit(down = before_origin(), 0, 0.1);
    EXPECT_LT((right.eye - 5 * Eigen::Vector3d(-std::sin(0.1), 0, -std::cos(0.1))).norm(), 1e-12);
    EXPECT_LT((down.eye - 5 * Eigen::Vector3d(0, -std::sin(0.1), -std::cos(0.1))).norm(), 1e-12);
}

TEST(Navigation, ApproachingAPointKeepsItUnderThePointer) {
    Navigation n = before_origin();
    const Eigen::Vector3d point(1.2, -0.7, 0.4);
    const Eigen::Vector2d before = shown_at(n, point);
    for (int i = 0; i < 100; ++i) {
        approach_point(n, point, 0.9, 0.1, 100);
        EXPECT_LT((shown_at(n, point) - before).norm(), 1e-6);
    }
    EXPECT_NEAR((n.eye - point).norm(), 0.1, 1e-9) << "the eye came closer than the limit";
    for (int i = 0; i < 200; ++i) approach_point(n, point, 1 / 0.9, 0.1, 100);
    EXPECT_NEAR((n.eye - point).norm(), 100, 1e-6) << "the eye went farther than the limit";
}

TEST(Navigation, OrbitingAboutAPointKeepsItsDistance) {
    Navigation n = before_origin();
    const Eigen::Vector3d pivot(1, 0.5, 0.3);
    const double distance = (n.eye - pivot).norm();
    for (int i = 0; i < 20; ++i) {
        orbit_about(n, pivot, 0.1, 0.05);
        EXPECT_NEAR((n.eye - pivot).norm(), distance, 1e-9);
        EXPECT_NEAR((n.target - n.eye).norm(), 5, 1e-9);
        EXPECT_LT((n.target - n.eye).normalized().cross(Eigen::Vector3d(n.R.row(2))).norm(), 1e-9);
    }
}

TEST(Navigation, FacingAPointPutsItInTheMiddle) {
    const Eigen::Vector3d point(1.2, -0.7, 0.4);
    const Navigation n = facing(before_origin(), point, 2);
    EXPECT_LT((shown_at(n, point) - Eigen::Vector2d(400, 300)).norm(), 1e-9);
    EXPECT_NEAR((n.eye - point).norm(), 2, 1e-12);
}
