#include "player/view/pinch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vantage {
namespace {

constexpr int view_width = 800, view_height = 600;

Navigation before_a_wall() {
    Navigation n;
    n.eye = {1, -8, 2};
    n.target = {1, 0, 2};
    n.up = Eigen::Vector3d::UnitZ();
    n.R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return n;
}

/// The pixel that shows a point.
Eigen::Vector2d pixel_of(const Navigation& n, const Eigen::Vector3d& point) {
    const View v = view_of(n, view_width, view_height);
    const Eigen::Vector3d p = v.cam_from_origin.R * point + v.cam_from_origin.t;
    return {v.intrinsics.fx * p.x() / p.z() + v.intrinsics.cx,
            v.intrinsics.fy * p.y() / p.z() + v.intrinsics.cy};
}

/// The point on the wall y = 0 behind a pixel. Before the pinch, the wall faces the camera.
Eigen::Vector3d on_wall(const Navigation& n, const Eigen::Vector2d& pixel) {
    const View v = view_of(n, view_width, view_height);
    const Eigen::Vector3d ray =
        n.R.transpose() * Eigen::Vector3d((pixel.x() - v.intrinsics.cx) / v.intrinsics.fx,
                                          (pixel.y() - v.intrinsics.cy) / v.intrinsics.fy, 1);
    return n.eye - ray * (n.eye.y() / ray.y());
}

/// In an orthographic picture, the points under the fingers stay under them.
void expect_under_fingers_orthographically(const FingerPair& before, const FingerPair& now) {
    Navigation n = before_a_wall();
    const double size = 20;
    const auto seen = [&] {
        return orthographic(view_of(n, view_width, view_height), (n.target - n.eye).norm(), size);
    };
    // Points need not be on the wall, because the distance to the camera's target does not matter.
    const auto shown = [&](const Eigen::Vector2d& pixel, double y) {
        const double scale = seen().orthographic_depth / seen().intrinsics.fx;
        return Eigen::Vector3d(1 + scale * (pixel.x() - view_width / 2.0), y,
                               2 - scale * (pixel.y() - view_height / 2.0));
    };
    const auto pixel = [&](const Eigen::Vector3d& point) {
        const Eigen::Vector4d clip = clip_from_origin(seen(), {1, 1e9}) * point.homogeneous();
        return Eigen::Vector2d((clip.x() / clip.w() + 1) / 2 * view_width,
                               (clip.y() / clip.w() + 1) / 2 * view_height);
    };
    const Eigen::Vector3d first = shown(before[0], 3), second = shown(before[1], -1),
                          middle = shown((before[0] + before[1]) / 2, 1);
    ASSERT_LT((pixel(first) - before[0]).norm(), 1e-3);
    follow_pinch(n, pinch_between(before, now), middle, seen(), 0.01, 1000);
    EXPECT_LT((pixel(middle) - (now[0] + now[1]) / 2).norm(), 1e-3);
    EXPECT_LT((pixel(first) - now[0]).norm(), 1e-3);
    EXPECT_LT((pixel(second) - now[1]).norm(), 1e-3);
}

void expect_under_fingers(const FingerPair& before, const FingerPair& now, double within) {
    Navigation n = before_a_wall();
    const FingerPair touched = before;
    const Eigen::Vector3d first = on_wall(n, touched[0]), second = on_wall(n, touched[1]),
                          middle = on_wall(n, (touched[0] + touched[1]) / 2);
    follow_pinch(n, pinch_between(before, now), middle, view_of(n, view_width, view_height), 0.01, 1000);
    EXPECT_LT((pixel_of(n, middle) - (now[0] + now[1]) / 2).norm(), 1e-6);
    EXPECT_LT((pixel_of(n, first) - now[0]).norm(), within);
    EXPECT_LT((pixel_of(n, second) - now[1]).norm(), within);
}

TEST(Pinch, WhatIsUnderTheFingersFollowsThem) {
    expect_under_fingers({{{350, 300}, {450, 300}}}, {{{390, 270}, {490, 270}}}, 1e-6);  // moved
    expect_under_fingers({{{350, 300}, {450, 300}}}, {{{300, 300}, {500, 300}}}, 1e-6);  // apart
    expect_under_fingers({{{350, 300}, {450, 300}}}, {{{400, 250}, {400, 350}}},
                         1e-6);  // a quarter turn clockwise
    // Away from the picture's center, rotation tilts the wall, so points follow only approximately.
    expect_under_fingers({{{520, 330}, {620, 350}}}, {{{500, 300}, {600, 360}}}, 4);
}

TEST(Pinch, OrthographicallyAllThatIsUnderTheFingersFollowsThem) {
    expect_under_fingers_orthographically({{{350, 300}, {450, 300}}}, {{{390, 270}, {490, 270}}});
    expect_under_fingers_orthographically({{{520, 330}, {620, 350}}}, {{{450, 330}, {690, 350}}});
    expect_under_fingers_orthographically({{{520, 330}, {620, 350}}}, {{{500, 300}, {600, 360}}});
}

TEST(Pinch, FingersInOnePlaceNeitherSpreadNorTurn) {
    const Pinch p = pinch_between({{{400, 300}, {400, 300}}}, {{{300, 300}, {500, 300}}});
    EXPECT_EQ(p.spread, 1);
    EXPECT_EQ(p.turned, 0);
    const Pinch together = pinch_between({{{300, 300}, {500, 300}}}, {{{400, 300}, {400, 300}}});
    EXPECT_EQ(together.spread, 1);
}

TEST(Pinch, StepsAreWorthAsMuchAsOneMovement) {
    std::mt19937 chance(1);
    std::uniform_real_distribution<double> across(0, view_width);
    const auto anywhere = [&] {
        return FingerPair{{{across(chance), across(chance)}, {across(chance), across(chance)}}};
    };
    for (int i = 0; i < 1000; ++i) {
        const FingerPair a = anywhere(), b = anywhere(), c = anywhere();
        const auto apart = [](const FingerPair& p) { return (p[0] - p[1]).norm() > 10; };
        if (!apart(a) || !apart(b) || !apart(c)) continue;
        const Pinch steps = then(pinch_between(a, b), pinch_between(b, c)), once = pinch_between(a, c);
        EXPECT_LT((steps.center - once.center).norm(), 1e-9);
        EXPECT_LT((steps.moved - once.moved).norm(), 1e-9);
        EXPECT_NEAR(steps.spread / once.spread, 1, 1e-9);
        const double turns = (steps.turned - once.turned) / (2 * std::numbers::pi);
        EXPECT_NEAR(turns, std::round(turns), 1e-9);
    }
}

}  // namespace
}  // namespace vantage
