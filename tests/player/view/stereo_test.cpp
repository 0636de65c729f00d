#include "player/view/stereo.h"

#include <gtest/gtest.h>

#include "base/text/error.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

View middle_view() { return view_towards({3, -8, 2}, {0.5, 1, -1}, Vector3d::UnitZ(), 50, 800, 600); }

/// The point, relative to the origin, that is `x` to the right of the view axis, `y` below it and `z` ahead.
Vector3d before(const View& view, double x, double y, double z) {
    return view.cam_from_origin.R.transpose() * (Vector3d(x, y, z) - view.cam_from_origin.t);
}

Eigen::Vector2d pixel(const View& view, const Vector3d& point) {
    const Vector3d p = view.cam_from_origin.R * point + view.cam_from_origin.t;
    const Intrinsics& k = view.intrinsics;
    return {k.cx + k.fx * p.x() / p.z(), k.cy + k.fy * p.y() / p.z()};
}

}  // namespace

TEST(Stereo, EyesAreBesideTheMiddleAndLookAhead) {
    const View middle = middle_view();
    const auto eyes = eye_views(middle, {.distance = 0.064}, 9);
    ASSERT_EQ(eyes.size(), 2u);
    const Vector3d left = eyes[0].cam_from_origin.center(), right = eyes[1].cam_from_origin.center();
    EXPECT_LT((left - before(middle, -0.032, 0, 0)).norm(), 1e-12);
    EXPECT_LT((right - before(middle, 0.032, 0, 0)).norm(), 1e-12);
    for (const View& eye : eyes) EXPECT_EQ(eye.cam_from_origin.R, middle.cam_from_origin.R);
}

TEST(Stereo, PicturesAgreeAtTheConvergenceAndNearerThingsCross) {
    const View middle = middle_view();
    const auto eyes = eye_views(middle, {.distance = 0.5, .convergence = 4}, 9);
    for (const double z : {2.0, 4.0, 20.0}) {
        const Vector3d point = before(middle, 0.3, -0.4, z);
        const Eigen::Vector2d l = pixel(eyes[0], point), r = pixel(eyes[1], point);
        EXPECT_NEAR(l.y(), r.y(), 1e-9) << "both eyes see the point at the same height";
        // Follows from similar triangles through the screen, which is 4 units away.
        EXPECT_NEAR(l.x() - r.x(), middle.intrinsics.fx * 0.5 * (1 / z - 1 / 4.0), 1e-9);
    }
}

TEST(Stereo, EyesAreAShareOfTheDistanceApartUnlessSaidOtherwise) {
    const auto apart = [](const Eyes& eyes) {
        const auto views = eye_views(middle_view(), eyes, 6);
        return (views[1].cam_from_origin.center() - views[0].cam_from_origin.center()).norm();
    };
    EXPECT_NEAR(apart({}), 0.2, 1e-12);
    EXPECT_NEAR(apart({.share = 0.1}), 0.6, 1e-12);
    EXPECT_NEAR(apart({.convergence = 3}), 0.1, 1e-12);
    EXPECT_NEAR(apart({.distance = 0.065, .convergence = 3}), 0.065, 1e-12);
}

TEST(Stereo, FramesAreDividedWithoutAPixelLeftOver) {
    for (const StereoMode mode :
         {StereoMode::side_by_side, StereoMode::over_under, StereoMode::anaglyph, StereoMode::checkerboard})
        EXPECT_EQ(eye_size(mode, stereo_size(mode, {37, 23})), (FrameSize{37, 23}));
    EXPECT_EQ(eye_size(StereoMode::side_by_side, {801, 600}), (FrameSize{400, 600}));
    EXPECT_EQ(eye_size(StereoMode::over_under, {1, 1}), (FrameSize{1, 1}));
}

TEST(Stereo, WhatHasNoDepthIsRefused) {
    const View middle = middle_view();
    EXPECT_THROW(eye_views(middle, {}, 0), Error);
    EXPECT_THROW(eye_views(middle, {}, std::nan("")), Error);
    EXPECT_THROW(eye_views(middle, {.distance = 1e300, .convergence = 1e-300}, 1), Error);
    EXPECT_THROW(eye_views(orthographic(middle, 5, 10), {}, 5), Error);
}
