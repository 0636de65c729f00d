// Pointing at a panel yields the pixel at that position.
#include "player/panels/panel.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <random>

using namespace vantage;
using Eigen::Vector2d, Eigen::Vector3d;

namespace {

Panel slanted() {
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.7, Vector3d::UnitY()) * Eigen::AngleAxisd(-0.4, Vector3d::UnitX()) *
         Eigen::AngleAxisd(0.2, Vector3d::UnitZ()))
            .toRotationMatrix();
    return {.origin = {1, -2, 3},
            .right = turn.col(0),
            .down = turn.col(1),
            .unit = 0.002,
            .width = 640,
            .height = 480};
}

}  // namespace

TEST(Panel, ARayMeetsThePixelThatItIsAimedAt) {
    const Panel panel = slanted();
    const Vector3d behind = panel.right.cross(panel.down);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int i = 0; i < 200; ++i) {
        const Vector2d pixel(share(random) * 640, share(random) * 480);
        const Vector3d aim = point_on(panel, pixel);
        const Vector3d from = aim - (0.2 + 3 * share(random)) * behind + share(random) * panel.right;
        const double length = 0.1 + share(random);
        const Vector3d along = (aim - from).normalized() * length;
        const auto hit = pixel_on(panel, from, along);
        ASSERT_TRUE(hit);
        EXPECT_LT((hit->pixel - pixel).norm(), 1e-7);
        EXPECT_NEAR(hit->distance * length, (aim - from).norm(), 1e-9);
        EXPECT_FALSE(pixel_on(panel, from, -along)) << "away from it";
        EXPECT_FALSE(pixel_on(panel, aim + (aim - from), -along)) << "from behind";
    }
}

TEST(Panel, BesideItOnlyItsPlaneIsMet) {
    const Panel panel = slanted();
    const Vector3d towards = panel.right.cross(panel.down);
    for (const Vector2d& pixel : {Vector2d(-1, 20), Vector2d(641, 20), Vector2d(20, -1), Vector2d(20, 481)}) {
        const Vector3d from = point_on(panel, pixel) - towards;
        EXPECT_FALSE(pixel_on(panel, from, towards));
        const auto hit = pixel_on_plane(panel, from, towards);
        ASSERT_TRUE(hit);
        EXPECT_LT((hit->pixel - pixel).norm(), 1e-7);
    }
}

TEST(Panel, RaysWithoutAnAnswerMissIt) {
    const Panel panel = slanted();
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const Vector3d from = point_on(panel, {100, 100}) - panel.right.cross(panel.down);
    for (const Vector3d& along : {Vector3d(0, 0, 0), Vector3d(nan, 0, 1), Vector3d(inf, 0, 1), panel.right,
                                  Vector3d(panel.right + panel.down)})
        EXPECT_FALSE(pixel_on(panel, from, along)) << along.transpose();
    EXPECT_FALSE(pixel_on(panel, {nan, 0, 0}, {0, 0, 1}));
    EXPECT_FALSE(pixel_on(panel, {inf, 0, 0}, {0, 0, 1}));
}
