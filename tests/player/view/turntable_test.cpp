#include "player/view/turntable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace vantage;
using Eigen::Vector3d;

namespace {

Navigation start() {
    const Vector3d eye(3, -4, 2), target(0, 0, 1), up(0, 0, 1);
    return {eye, target, up, view_towards(eye, target, up, 40, 1, 1).cam_from_origin.R, 40};
}
double azimuth(const Navigation& n) { return std::atan2(n.eye.y(), n.eye.x()); }

}  // namespace

TEST(Turntable, GoesOnceAroundInEqualStepsAndCloses) {
    const std::vector<Navigation> frames = turntable(start(), 36);
    ASSERT_EQ(frames.size(), 36u);
    EXPECT_EQ(frames[0].eye, start().eye);
    double sum = 0;
    for (std::size_t i = 0; i < 36; ++i) {
        const Navigation &n = frames[i], &next = frames[(i + 1) % 36];
        EXPECT_NEAR(n.eye.z(), 2, 1e-9);
        EXPECT_NEAR(n.eye.head<2>().norm(), 5, 1e-9);
        EXPECT_LT((n.R.row(2).transpose() - (n.target - n.eye).normalized()).norm(), 1e-9)
            << "every view looks at the center";
        EXPECT_NEAR(n.R.row(0).dot(n.up), 0, 1e-9);
        const double step = std::remainder(azimuth(next) - azimuth(n), 2 * std::numbers::pi);
        EXPECT_NEAR(std::abs(step), std::numbers::pi / 18, 1e-9) << i;
        sum += step;
    }
    EXPECT_NEAR(std::abs(sum), 2 * std::numbers::pi, 1e-9) << "the camera always moves in the same direction";
}

TEST(Turntable, SwingsToBothSidesOfAnArc) {
    const std::vector<Navigation> frames = turntable(start(), 100, {-45, 45});
    double low = 0, high = 0;
    for (const Navigation& n : frames) {
        const double a =
            std::remainder(azimuth(n) - azimuth(start()), 2 * std::numbers::pi) * 180 / std::numbers::pi;
        low = std::min(low, a);
        high = std::max(high, a);
    }
    EXPECT_NEAR(low, -45, 1e-6);
    EXPECT_NEAR(high, 45, 1e-6);
}
