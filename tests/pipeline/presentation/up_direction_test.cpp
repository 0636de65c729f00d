#include "pipeline/presentation/up_direction.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "pipeline/synth/synthesize.h"

using namespace vantage;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double degree = std::numbers::pi / 180;

double degrees_between(const Vector3d& a, const Vector3d& b) {
    return std::acos(std::clamp(a.dot(b), -1.0, 1.0)) / degree;
}

/// The camera, rolled about its axis, clockwise from the photographer's point of view.
Pose rolled(const Pose& pose, double degrees) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(-degrees * degree, Vector3d::UnitZ()).toRotationMatrix();
    return {R * pose.R, R * pose.t};
}

/// Cameras on an arc in front of a facade, level to within about a degree and tilted upward.
std::vector<Pose> photographer(int count, double arc, double tilt, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> roll(0, 1);
    std::vector<Pose> out;
    for (int i = 0; i < count; ++i) {
        const double angle = arc * degree * (double(i) / std::max(1, count - 1) - 0.5);
        const Vector3d eye(10 * std::sin(angle), -10 * std::cos(angle), 1.6);
        out.push_back(rolled(look_at(eye, {0, 0, 1.6 + 10 * std::tan(tilt * degree)}), roll(random)));
    }
    return out;
}

std::vector<Pose> in_frame(std::vector<Pose> poses, const Eigen::Matrix3d& R) {
    for (Pose& p : poses) p.R = p.R * R.transpose();
    return poses;
}

/// Discs on a vertical wall with this normal.
std::vector<SurfaceDisc> standing(const Vector3f& normal, int count) {
    const Vector3f across = Vector3f::UnitZ().cross(normal);
    std::vector<SurfaceDisc> out;
    for (int i = 0; i < count; ++i)
        out.push_back(
            {across * (float(i % 20) / 5 - 2) + Vector3f(0, 0, float(i) / float(count) * 4), normal, 0.1f});
    return out;
}

}  // namespace

TEST(UpDirection, IsNotThatInWhichPhotographersLean) {
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
        const Eigen::Matrix3d R =
            Eigen::AngleAxisd(0.5 + seed, Vector3d(1, 2, double(seed)).normalized()).toRotationMatrix();
        const std::vector<Pose> poses = in_frame(photographer(10, 90, 15, seed), R);
        Vector3d mean = Vector3d::Zero();
        for (const Pose& p : poses) mean -= p.R.row(1).transpose();
        const Vector3d up = up_direction(poses, {});
        EXPECT_LT(degrees_between(up, R * Vector3d::UnitZ()), 2) << seed;
        EXPECT_GT(degrees_between(mean.normalized(), R * Vector3d::UnitZ()), 12)
            << "the mean of the columns is tilted";
    }
}

TEST(UpDirection, IsTheNearestAxisIfTheErrorAllowsIt) {
    EXPECT_EQ(up_direction(photographer(10, 90, 15), {}), Vector3d::UnitZ());
    const Eigen::Matrix3d down = Eigen::AngleAxisd(180 * degree, Vector3d::UnitX()).toRotationMatrix();
    EXPECT_EQ(up_direction(in_frame(photographer(10, 90, 15), down), {}), -Vector3d::UnitZ());
    const Eigen::Matrix3d tipped = Eigen::AngleAxisd(8 * degree, Vector3d::UnitY()).toRotationMatrix();
    const Vector3d up = up_direction(in_frame(photographer(40, 180, 15), tipped), {});
    EXPECT_LT(degrees_between(up, tipped * Vector3d::UnitZ()), 1) << "not the axis, which is 8 degrees away";
}

TEST(UpDirection, CountsCamerasOnTheirSidesByTheirColumns) {
    std::vector<Pose> poses = photographer(12, 120, 10);
    for (std::size_t i = 0; i < poses.size(); i += 3) poses[i] = rolled(poses[i], i % 2 ? 90 : -90);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(1, Vector3d(1, 1, 0).normalized()).toRotationMatrix();
    EXPECT_LT(degrees_between(up_direction(in_frame(poses, R), {}), R * Vector3d::UnitZ()), 2);
}

TEST(UpDirection, IsThatOfWallsWhereAllCamerasWereRolled) {
    std::vector<Pose> poses = photographer(8, 30, 12);
    for (Pose& p : poses) p = rolled(p, 4);
    ASSERT_GT(degrees_between(up_of_cameras(poses).up, Vector3d::UnitZ()), 3) << "rows alone mislead";
    std::vector<SurfaceDisc> house = standing(Vector3f::UnitY(), 300);
    for (const SurfaceDisc& d : standing(Vector3f::UnitX(), 270)) house.push_back(d);
    std::mt19937 random(1);
    std::normal_distribution<float> rough(0, 0.02f);
    for (SurfaceDisc& d : house)
        d.normal = (d.normal + Vector3f(rough(random), rough(random), rough(random))).normalized();
    EXPECT_LT(degrees_between(up_direction(poses, house), Vector3d::UnitZ()), 0.3);
}

TEST(UpDirection, IsHeldAlongTheOnlyWallAndUnknownWithoutWalls) {
    const Vector3d held = Vector3d(0.02, 0.1, 1).normalized();
    const auto up = up_of_surface(standing(Vector3f::UnitY(), 400), held);
    ASSERT_TRUE(up);
    EXPECT_NEAR(up->y(), 0, 1e-3) << "parallel to the wall";
    EXPECT_NEAR(up->x(), held.x(), 2e-3) << "as held";
    std::mt19937 random(1);
    std::normal_distribution<float> any(0, 1);
    std::vector<SurfaceDisc> ball;
    for (int i = 0; i < 600; ++i) {
        const Vector3f n = Vector3f(any(random), any(random), any(random)).normalized();
        ball.push_back({n, n, 0.1f});
    }
    EXPECT_FALSE(up_of_surface(ball, held));
}

TEST(UpDirection, IsFiniteForFewCamerasAndThoseThatLookDown) {
    EXPECT_EQ(up_direction({}, {}), Vector3d::UnitZ());
    const auto one = photographer(1, 0, 5);
    EXPECT_LT(degrees_between(up_direction(one, {}), Vector3d::UnitZ()), 10);
    const std::vector<Pose> same(5, one[0]);
    EXPECT_NEAR(up_direction(same, {}).norm(), 1, 1e-9);
    // Strips of aerial photos, which are flown in alternating directions.
    std::vector<Pose> strips;
    for (int i = 0; i < 10; ++i) {
        Pose down{Vector3d(1, -1, -1).asDiagonal(), {0, 0, 0}};
        strips.push_back(rolled(down, i % 2 ? 180 : 0));
    }
    EXPECT_LT(degrees_between(up_direction(strips, {}), Vector3d::UnitZ()), 1);
}
