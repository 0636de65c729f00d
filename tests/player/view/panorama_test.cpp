#include "player/view/panorama.h"

#include <gtest/gtest.h>

#include <numbers>

#include "base/text/error.h"
#include "tests/player/test_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

Panorama panorama() {
    const View view = view_towards({1, 2, 3}, {4, -2, 1}, Vector3d::UnitZ(), 50, 640, 480);
    return panorama_at(view, Vector3d::UnitZ(), {2000, 1000});
}

}  // namespace

TEST(Panorama, IsLevelWithTheViewsDirectionInItsMiddle) {
    const Panorama p = panorama();
    EXPECT_LT((p.R * Vector3d::UnitZ() - Vector3d(0, -1, 0)).norm(), 1e-12) << "up is up";
    EXPECT_NEAR(p.R.determinant(), 1, 1e-12);
    const Vector3d looked_at = p.R * (Vector3d(4, -2, 1) - p.eye);
    EXPECT_NEAR(pixel_of(p, looked_at).x(), 1000, 1e-9);
    EXPECT_GT(pixel_of(p, looked_at).y(), 500) << "the point is below the eye";
}

TEST(Panorama, LongitudesRunToTheRightAndLatitudesDown) {
    const Panorama p = panorama();
    const auto at = [&](const Vector3d& d) { return pixel_of(p, d); };
    EXPECT_LT((at({0, 0, 1}) - Eigen::Vector2d(1000, 500)).norm(), 1e-9);
    EXPECT_LT((at({1, 0, 0}) - Eigen::Vector2d(1500, 500)).norm(), 1e-9);
    EXPECT_LT((at({-1, 0, 0}) - Eigen::Vector2d(500, 500)).norm(), 1e-9);
    EXPECT_NEAR(at({0, -1, 1e-9}).y(), 0, 1e-4);
    EXPECT_NEAR(at({0, 1, 1e-9}).y(), 1000, 1e-4);
    // 30 degrees to the right, and 10 above the horizon.
    const double l = std::numbers::pi / 6, b = std::numbers::pi / 18;
    const Vector3d d(std::cos(b) * std::sin(l), -std::sin(b), std::cos(b) * std::cos(l));
    EXPECT_LT((at(d) - Eigen::Vector2d(1000 + 2000 / 12.0, 500 - 1000 / 18.0)).norm(), 1e-9);
}

TEST(Panorama, EveryDirectionIsInTheFaceThatFacesIt) {
    const Panorama p = panorama();
    const auto views = cube_views(p, 1.5, 0);
    const auto axes = cube_axes();
    Random random;
    for (int i = 0; i < 2000; ++i) {
        const Vector3d d = random.vector(1).normalized();
        int shown = 0;
        for (std::size_t face = 0; face < 6; ++face) {
            EXPECT_LT((views[face].cam_from_origin.R - axes[face] * p.R).norm(), 1e-12);
            const auto seen =
                project(views[face].intrinsics, views[face].cam_from_origin, p.eye + p.R.transpose() * d);
            shown += seen && in_frame(views[face].intrinsics, seen->pixel);
        }
        EXPECT_GE(shown, 1);
        EXPECT_LE(shown, 3) << "more than one face may show a direction only near an edge or a corner";
    }
}

TEST(Panorama, LooksAheadEvenFromAViewStraightDown) {
    const View down = view_towards({0, 0, 5}, {0, 0, 0}, Vector3d::UnitY(), 50, 640, 480);
    const Panorama p = panorama_at(down, Vector3d::UnitZ(), {200, 100});
    EXPECT_TRUE(p.R.allFinite());
    EXPECT_NEAR(p.R.determinant(), 1, 1e-12);
}

TEST(Panorama, OtherShapesAreRefused) {
    const View view = view_towards({1, 2, 3}, {4, -2, 1}, Vector3d::UnitZ(), 50, 640, 480);
    EXPECT_THROW(panorama_at(view, Vector3d::UnitZ(), {1000, 1000}), Error);
    EXPECT_THROW(panorama_at(view, Vector3d::UnitZ(), {0, 0}), Error);
}
