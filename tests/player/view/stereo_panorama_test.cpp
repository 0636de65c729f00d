#include "player/view/stereo_panorama.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "base/text/error.h"
#include "tests/player/test_scene.h"

using namespace vantage;
using Eigen::Vector2d, Eigen::Vector3d;

namespace {

using std::numbers::pi;

constexpr double nearest = 0.8, apart = 0.07;

Panorama middle() {
    const View view = view_towards({1, 2, 3}, {4, -2, 1}, Vector3d::UnitZ(), 50, 640, 480);
    return panorama_at(view, Vector3d::UnitZ(), {2000, 1000});
}

/// The direction in which an eye that moves on a circle sees a point: longitude and angle below the horizon,
/// along the panorama's axes. The eye's line of sight through the point is tangent to the circle.
Vector2d seen_by(bool right_eye, const Vector3d& point) {
    const double across = std::hypot(point.x(), point.z()), radius = apart / 2;
    const double along = std::sqrt(across * across - radius * radius);
    const double turned = std::asin(radius / across);
    return {std::atan2(point.x(), point.z()) + (right_eye ? -turned : turned), std::atan2(point.y(), along)};
}

}  // namespace

TEST(StereoPanorama, ShowsPointsWhereEyesThatTurnSeeThem) {
    const Panorama around = middle();
    const StereoPanorama p = stereo_panorama(around, apart, nearest);
    EXPECT_GT(p.columns, 1);
    Random random;
    for (int i = 0; i < 4000; ++i) {
        // Points above or below the eyes are skipped: on the circle's axis, no line of sight is tangent to
        // the circle.
        Vector3d point = random.vector(1).normalized() * (nearest + 20 * i / 4000.0);
        if (std::hypot(point.x(), point.z()) < 0.5 * nearest) continue;
        for (const bool right : {false, true}) {
            const Vector2d at = seen_by(right, point);
            const double column = std::fmod(2 + at.x() / (2 * pi) + 0.5, 1) * 2000;
            const int slice = int(column) / p.columns;
            const ColumnRange columns = columns_of(p, slice);
            ASSERT_GE(column, columns.first);
            ASSERT_LT(column, columns.first + columns.count);
            int shown = 0;
            const auto eyes = eyes_of_slice(p, slice, 1.5, 0);
            const auto axes = slice_axes(p, slice);
            for (std::size_t v = 0; v < slice_views; ++v) {
                const View& view = eyes[v][right];
                const auto seen =
                    project(view.intrinsics, view.cam_from_origin, around.eye + around.R.transpose() * point);
                if (!seen || !in_frame(view.intrinsics, seen->pixel)) continue;
                ++shown;
                const Intrinsics& k = view.intrinsics;
                const Vector3d direction = axes[v].transpose() * Vector3d((seen->pixel.x() - k.cx) / k.fx,
                                                                          (seen->pixel.y() - k.cy) / k.fy, 1);
                const Vector2d off =
                    pixel_of(around, direction) - Vector2d(column, (at.y() / pi + 0.5) * 1000);
                // The error in pixels at the horizon; other rows are stretched.
                const double wide = std::remainder(off.x(), 2000) * std::cos(at.y());
                EXPECT_LT(std::hypot(wide, off.y()), 0.5 * nearest / point.norm()) << point.transpose();
            }
            EXPECT_GE(shown, 1) << point.transpose();
        }
    }
}

TEST(StereoPanorama, SlicesShowEveryColumnOnce) {
    for (const double near : {0.0, 0.01, 0.3, 1.0, 1e9, std::numeric_limits<double>::infinity()}) {
        const StereoPanorama p = stereo_panorama(middle(), apart, near);
        int next = 0;
        for (int s = 0; s < slice_count(p); ++s) {
            const ColumnRange columns = columns_of(p, s);
            EXPECT_EQ(columns.first, next);
            EXPECT_GE(columns.count, 1);
            next += columns.count;
        }
        EXPECT_EQ(next, 2000) << near;
        EXPECT_LE(p.columns, 2000 / 12) << "views stay narrow";
    }
}

TEST(StereoPanorama, TooSmallOnesAreRefused) {
    Panorama small = middle();
    small.size = {2, 1};
    EXPECT_THROW(stereo_panorama(small, apart, nearest), Error);
    small.size = {12, 6};
    const StereoPanorama p = stereo_panorama(small, apart, nearest);
    EXPECT_EQ(slice_count(p), 12);
    EXPECT_LT(eyes_of_slice(p, 3, 1.5, 0)[1][0].intrinsics.width, 100);
}

TEST(StereoPanorama, NearerThingsTakeNarrowerSlices) {
    EXPECT_LT(slice_count(stereo_panorama(middle(), apart, 2)),
              slice_count(stereo_panorama(middle(), apart, 0.5)));
    EXPECT_EQ(stereo_panorama(middle(), apart, 0.5).columns, int(0.5 * 0.5 / 0.035));
}
