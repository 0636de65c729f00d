#include "player/view/camera_spline.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

using namespace vantage;
using Eigen::Vector3d;

namespace {

using std::numbers::pi;

Navigation looking(const Vector3d& eye, const Vector3d& target, double fov = 40) {
    const Vector3d up = Vector3d::UnitZ();
    return {eye, target, up, view_towards(eye, target, up, fov, 1, 1).cam_from_origin.R, fov};
}

/// Four views around the origin; the camera rests at the second.
std::vector<KeyView> round_trip() {
    return {{looking({10, 0, 2}, {0, 0, 0}), 0},
            {looking({0, 10, 2}, {0, 0, 0}, 30), 2},
            {looking({0, 10, 2}, {0, 0, 0}, 30), 3},
            {looking({-10, 1, 1}, {1, 0, 1}), 5},
            {looking({-3, -6, 4}, {0, 1, 0}), 6}};
}

double speed(const CameraSpline& spline, double at, double h = 1e-5) {
    return (spline.at(at + h).eye - spline.at(at - h).eye).norm() / (2 * h);
}

double turning(const CameraSpline& spline, double at, double h = 1e-5) {
    return Eigen::AngleAxisd(spline.at(at + h).R * spline.at(at - h).R.transpose()).angle() / (2 * h);
}

}  // namespace

TEST(CameraSpline, MeetsEveryKeyAtItsTime) {
    const std::vector<KeyView> keys = round_trip();
    const CameraSpline spline(keys);
    EXPECT_EQ(spline.seconds(), 6);
    for (const KeyView& key : keys) {
        const Navigation n = spline.at(key.seconds);
        EXPECT_LT((n.eye - key.camera.eye).norm(), 1e-9) << key.seconds;
        EXPECT_LT((n.R - key.camera.R).norm(), 1e-9) << key.seconds;
        EXPECT_NEAR(n.fov, key.camera.fov, 1e-9) << key.seconds;
    }
    EXPECT_EQ(spline.at(-1).eye, spline.at(0).eye);
    EXPECT_EQ(spline.at(99).eye, spline.at(6).eye);
}

TEST(CameraSpline, SpeedsAreContinuousAndItRestsAtBothEnds) {
    const CameraSpline spline(round_trip());
    for (const double key : {2.0, 3.0, 5.0}) {
        const double before = speed(spline, key - 1e-4), after = speed(spline, key + 1e-4);
        EXPECT_NEAR(before, after, 0.02) << key;
        EXPECT_NEAR(turning(spline, key - 1e-4), turning(spline, key + 1e-4), 0.01) << key;
    }
    EXPECT_GT(speed(spline, 5), 1) << "the camera stops at a view where it should not rest";
    EXPECT_LT(speed(spline, 1e-4), 0.02);
    EXPECT_LT(speed(spline, 6 - 1e-4), 0.02);
    for (const double held : {2.1, 2.5, 2.9})
        EXPECT_LT((spline.at(held).eye - Vector3d(0, 10, 2)).norm(), 1e-9);
}

TEST(CameraSpline, FliesAroundTheObjectAndStaysLevel) {
    const std::vector<KeyView> keys{{looking({10, 0, 0}, {0, 0, 0}), 0},
                                    {looking({-7, 7.2, 0}, {0, 0, 0}), 4}};
    const CameraSpline spline(keys);
    for (double t = 0; t <= 4; t += 0.125) {
        const Navigation n = spline.at(t);
        EXPECT_GT(n.eye.norm(), 9.9) << "the straight line comes within 4 units of the origin";
        EXPECT_LT(n.eye.norm(), 10.1);
        EXPECT_NEAR(n.R.row(0).dot(Vector3d::UnitZ()), 0, 1e-9) << "the horizon is level";
        EXPECT_NEAR(n.R.determinant(), 1, 1e-9);
        EXPECT_LT((n.R * n.R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
    }
    // Halfway in time is halfway in angle: acceleration and deceleration are symmetric.
    const double angle = std::acos(-7 / std::hypot(7, 7.2));
    EXPECT_LT((spline.at(2).eye.normalized() - Vector3d(std::cos(angle / 2), std::sin(angle / 2), 0)).norm(),
              1e-6);
}

TEST(CameraSpline, KeepsRollsAndCutsBetweenKeysAtTheSameTime) {
    Navigation rolled = looking({10, 0, 0}, {0, 0, 0});
    rolled.R = Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix() * rolled.R;
    const Navigation level = looking({0, 10, 0}, {0, 0, 0});
    const std::vector<KeyView> keys{{rolled, 0}, {rolled, 1}, {level, 1}, {level, 2}};
    const CameraSpline spline(keys);
    EXPECT_LT((spline.at(0.999).eye - Vector3d(10, 0, 0)).norm(), 1e-9);
    EXPECT_LT((spline.at(0.999).R - rolled.R).norm(), 1e-9);
    EXPECT_LT((spline.at(1).eye - Vector3d(0, 10, 0)).norm(), 1e-9);
}

TEST(CameraSpline, IsFiniteForOneKeyAndForOppositeViews) {
    const KeyView one{looking({1, 2, 3}, {0, 0, 0}), 4};
    EXPECT_EQ(CameraSpline(std::span(&one, 1)).seconds(), 4);
    EXPECT_LT((CameraSpline(std::span(&one, 1)).at(0).eye - Vector3d(1, 2, 3)).norm(), 1e-9);
    const std::vector<KeyView> opposite{{looking({5, 0, 0}, {0, 0, 0}), 0},
                                        {looking({-5, 0, 0}, {0, 0, 0}), 1},
                                        {looking({0, 0, 1e-7}, {0, 0, -1e6}), 1.5}};
    const CameraSpline spline(opposite);
    for (double t = 0; t <= 1.5; t += 0.05) {
        const Navigation n = spline.at(t);
        EXPECT_TRUE(n.eye.allFinite() && n.R.allFinite()) << t;
        EXPECT_GT((n.eye - n.target).norm(), 0) << t;
    }
}
