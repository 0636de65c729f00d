#include "pipeline/mesh/deviation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "pipeline/mesh/subdivide.h"

using namespace vantage;

namespace {

/// A closed box between `low` and `high`, with triangles facing outward.
Mesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    Mesh m;
    for (int i = 0; i < 8; ++i)
        m.positions.push_back(low +
                              Eigen::Vector3d(i & 1, i >> 1 & 1, i >> 2).cwiseProduct((high - low).eval()));
    m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return m;
}

/// The distance to the box in closed form; negative inside.
double distance_to_box(const Eigen::Vector3d& p, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    const Eigen::Vector3d outside = (low - p).cwiseMax(p - high);
    return outside.cwiseMax(0).norm() + std::min(outside.maxCoeff(), 0.0);
}

/// Points around the box. For some, the nearest part of the box is a face; for others, an edge or a corner.
Mesh around(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-0.8, 1.8);
    std::uniform_int_distribution<int> which(0, 4);
    Mesh m;
    for (int i = 0; i < 5000; ++i) {
        Eigen::Vector3d share;
        for (double& s : share) {
            constexpr double special[] = {0, 0.5, 1};
            const int w = which(random);
            s = w < 3 ? special[w] : anywhere(random);
        }
        m.positions.push_back(low + share.cwiseProduct((high - low).eval()));
    }
    return m;
}

}  // namespace

TEST(Deviation, FromABoxIsItsClosedForm) {
    for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(481234, 5412345, 312)}) {
        const Eigen::Vector3d low = at + Eigen::Vector3d(-1, -2, 0.5),
                              high = at + Eigen::Vector3d(2, 1, 1.25);
        const Mesh points = around(low, high);
        Mesh coarse = box(low, high), fine = coarse;
        subdivide_large_triangles(fine, main_box(fine));
        for (const Mesh& reference : {coarse, fine}) {
            const std::vector<float> found = deviation(points, reference);
            ASSERT_EQ(found.size(), points.positions.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                const double expected = distance_to_box(points.positions[i], low, high);
                EXPECT_NEAR(found[i], expected, 1e-6) << (points.positions[i] - at).transpose();
            }
        }
    }
}

/// Where several triangles meet, some of them may face away from a point outside.
TEST(Deviation, OfAPointBesideABladeIsOutside) {
    Mesh blade, points;  // a thin spike along +x with its tip at the origin
    constexpr double half = 0.05;
    blade.positions = {{0, 0, 0}, {1, -half, -half}, {1, half, -half}, {1, half, half}, {1, -half, half}};
    blade.triangles = {{0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}};
    // One side is a fan of many triangles, but it must not outweigh the other sides.
    constexpr std::uint32_t parts = 20;
    for (std::uint32_t i = 1; i < parts; ++i)
        blade.positions.emplace_back(1, half - 2 * half * i / parts, -half);
    for (std::uint32_t i = 0; i < parts; ++i)
        blade.triangles.push_back({0, i == 0 ? 2 : 4 + i, i + 1 == parts ? 1 : 5 + i});
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3d direction = Eigen::Vector3d(normal(random), normal(random), normal(random));
        for (const Eigen::Vector3d& from :
             {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.5, half / 2, half / 2)})
            points.positions.push_back(from + 0.02 * direction.normalized());
    }
    const std::vector<Eigen::Vector3d> upright = points.positions;
    const Eigen::Quaterniond turn(0.4, -0.3, 0.7, 0.5);  // axis-aligned boxes are not sufficient
    for (Mesh* m : {&blade, &points})
        for (Eigen::Vector3d& p : m->positions) p = turn.normalized() * p;
    const std::vector<float> found = deviation(points, blade);
    int outside = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Eigen::Vector3d& p = upright[i];
        const double depth = half * p.x() - std::max(std::abs(p.y()), std::abs(p.z()));  // above 0: inside
        if (std::abs(depth) < 1e-9) continue;
        outside += depth < 0;
        EXPECT_EQ(found[i] > 0, depth < 0) << p.transpose();
    }
    EXPECT_GT(outside, 3000);
}

TEST(Deviation, IsThatOfTheNearestOfAllTriangles) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto anywhere = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)); };
    Mesh soup, points;
    for (std::uint32_t t = 0; t < 200; ++t) {
        const Eigen::Vector3d a = 3 * anywhere();
        soup.positions.insert(soup.positions.end(), {a, a + anywhere(), a + 0.1 * anywhere()});
        soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    // A triangle without area is treated as its longest edge.
    soup.positions.insert(soup.positions.end(), {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
    soup.triangles.push_back({600, 601, 602});
    for (int i = 0; i < 200; ++i) points.positions.push_back(3 * anywhere());
    const std::vector<float> found = deviation(points, soup);
    for (std::size_t i = 0; i < found.size(); ++i) {
        // Samples of the triangles, including their corners, are never nearer than the surface, but the
        // nearest sample is almost as near.
        double sampled = 1e9;
        constexpr int steps = 60;
        for (const auto& t : soup.triangles)
            for (int u = 0; u <= steps; ++u)
                for (int v = 0; u + v <= steps; ++v) {
                    const Eigen::Vector3d p = (soup.positions[t[0]] * u + soup.positions[t[1]] * v +
                                               soup.positions[t[2]] * (steps - u - v)) /
                                              steps;
                    sampled = std::min(sampled, (p - points.positions[i]).norm());
                }
        EXPECT_LE(std::abs(found[i]), sampled + 1e-6);
        EXPECT_GE(std::abs(found[i]), sampled - 0.05);
    }
}

TEST(Deviation, FromACloudIsToItsNearestPointSignedByNormals) {
    Mesh cloud, points;
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 20; ++y) cloud.positions.emplace_back(0.1 * x, 0.1 * y, 0);
    points.positions = {{1, 1, 0.3}, {1, 1, -0.2}, {1.03, 1.04, 0}, {-4, 0, 3}};
    const std::vector<float> unsigned_distance = deviation(points, cloud);
    EXPECT_FLOAT_EQ(unsigned_distance[0], 0.3f);
    EXPECT_FLOAT_EQ(unsigned_distance[1], 0.2f);
    EXPECT_NEAR(unsigned_distance[2], 0.05, 1e-6);
    EXPECT_FLOAT_EQ(unsigned_distance[3], 5.0f);
    cloud.normals.assign(cloud.positions.size(), {0, 0, -1});
    const std::vector<float> signed_distance = deviation(points, cloud);
    EXPECT_FLOAT_EQ(signed_distance[0], -0.3f);
    EXPECT_FLOAT_EQ(signed_distance[1], 0.2f);
}

TEST(Deviation, OfOneTriangleAndOfNothing) {
    Mesh triangle, points;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    triangle.triangles = {{0, 1, 2}};
    points.positions = {{0.25, 0.25, 2}, {0.25, 0.25, -2}, {-3, 0, 0}, {0, 0, 0}, {1e12, 0, 0}};
    const std::vector<float> found = deviation(points, triangle);
    EXPECT_FLOAT_EQ(found[0], 2);
    EXPECT_FLOAT_EQ(found[1], -2);
    EXPECT_FLOAT_EQ(std::abs(found[2]), 3);
    EXPECT_FLOAT_EQ(std::abs(found[3]), 0);
    EXPECT_FLOAT_EQ(std::abs(found[4]), 1e12f);
    EXPECT_TRUE(deviation({}, triangle).empty());
    for (const float d : deviation(points, {})) EXPECT_TRUE(std::isnan(d));
}
