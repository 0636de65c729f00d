#include "pipeline/stages/coordinates/footprint_hull.h"

#include <gtest/gtest.h>

using namespace vantage;

TEST(FootprintHull, DegenerateSetsHaveADirection) {
    const Intrinsics k{100, 80, 90, 90, 50, 40};
    const Pose pose;
    const auto nothing = footprint_hull({{-1, -1}}, k, pose);
    EXPECT_EQ(nothing.area, 0);
    EXPECT_TRUE(nothing.direction.isApprox(Eigen::Vector3d::UnitZ()));
    const auto line = footprint_hull({{0.25f, 0.5f}, {0.5f, 0.5f}, {0.75f, 0.5f}}, k, pose);
    EXPECT_EQ(line.area, 0);
    EXPECT_TRUE(line.direction.isApprox(Eigen::Vector3d::UnitZ(), 1e-6));
    const auto square = footprint_hull({{0, 0}, {1, 0}, {1, 0.5f}, {0, 0.5f}, {0.5f, 0.25f}}, k, pose);
    EXPECT_NEAR(square.area, 0.5, 1e-6);
    EXPECT_NEAR(square.direction.y() / square.direction.z(), (0.25 * 80 - 40) / 90, 1e-5);
}
