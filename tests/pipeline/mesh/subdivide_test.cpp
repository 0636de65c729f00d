#include "pipeline/mesh/subdivide.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

using namespace vantage;

namespace {

/// A closed box that consists of 12 triangles; `size` is the length of its edges.
Mesh box(const Eigen::Vector3d& size) {
    Mesh m;
    VertexField height{"height", {}};
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d p(i & 1, i >> 1 & 1, i >> 2);
        m.positions.push_back(p.cwiseProduct(size));
        m.normals.push_back((p - Eigen::Vector3d::Constant(0.5)).normalized().cast<float>());
        m.colors.push_back({std::uint8_t(200 * p.x()), 7, 7, 255});
        height.values.push_back(float(m.positions.back().z()));
    }
    m.scalars.push_back(height);
    m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return m;
}

Eigen::Vector3d area_vector(const Mesh& m, const std::array<std::uint32_t, 3>& t) {
    return (m.positions[t[1]] - m.positions[t[0]]).cross(m.positions[t[2]] - m.positions[t[0]]) / 2;
}

double area(const Mesh& m) {
    double sum = 0;
    for (const auto& t : m.triangles) sum += area_vector(m, t).norm();
    return sum;
}

double volume(const Mesh& m) {
    double sum = 0;
    for (const auto& t : m.triangles) sum += area_vector(m, t).dot(m.positions[t[0]]) / 3;
    return sum;
}

}  // namespace

TEST(Subdivide, SurfaceStaysClosedAndEdgesBecomeShort) {
    const Eigen::Vector3d size(3, 2, 0.1);
    const Mesh before = box(size);
    Mesh m = before;
    const std::size_t added = subdivide_large_triangles(m, main_box(m));
    EXPECT_EQ(m.triangles.size(), before.triangles.size() + added);
    EXPECT_GT(m.triangles.size(), 1000u);
    EXPECT_NEAR(area(m), area(before), 1e-9);
    EXPECT_NEAR(volume(m), size.prod(), 1e-9) << "every piece keeps the winding of its triangle";
    std::map<std::array<std::uint32_t, 2>, int> edges;  // uses in one direction minus uses in the other
    for (const auto& t : m.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            EXPECT_LE((m.positions[a] - m.positions[b]).norm(), size.norm() / 64 + 1e-12);
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    for (const auto& [edge, balance] : edges) ASSERT_EQ(balance, 0) << "the closed surface has a hole";
}

TEST(Subdivide, AttributesAreInterpolated) {
    Mesh m = box({2, 2, 2});
    subdivide_large_triangles(m, main_box(m));
    ASSERT_EQ(m.normals.size(), m.positions.size());
    ASSERT_EQ(m.colors.size(), m.positions.size());
    ASSERT_EQ(m.scalars[0].values.size(), m.positions.size());
    for (std::size_t v = 0; v < m.positions.size(); ++v) {
        EXPECT_NEAR(m.normals[v].norm(), 1, 1e-5);
        EXPECT_NEAR(m.colors[v][0], 100 * m.positions[v].x(), 4) << "each halving rounds";
        EXPECT_NEAR(m.scalars[0].values[v], m.positions[v].z(), 1e-5);
    }
}

TEST(Subdivide, FineOrEmptyMeshesStayUnchanged) {
    Mesh m = box({1, 1, 1});
    subdivide_large_triangles(m, main_box(m));
    EXPECT_EQ(subdivide_large_triangles(m, main_box(m)), 0u);
    Mesh point = box({0, 0, 0});
    EXPECT_EQ(subdivide_large_triangles(point, main_box(point)), 0u);
    Mesh empty;
    EXPECT_EQ(subdivide_large_triangles(empty, main_box(empty)), 0u);
}

TEST(Subdivide, ManyLongSliversDoNotExplode) {
    Mesh m;
    constexpr std::uint32_t slivers = 20000;
    for (std::uint32_t i = 0; i < slivers; ++i) {
        const double y = i;
        for (const Eigen::Vector3d& p : {Eigen::Vector3d(0, y, 0), {0, y + 0.5, 0}, {1e5, y, 0}}) {
            m.positions.push_back(p);
            m.normals.emplace_back(0, 0, 1);
        }
        m.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const double before = area(m);
    EXPECT_LE(subdivide_large_triangles(m, main_box(m)), std::size_t(1) << 18);
    EXPECT_NEAR(area(m), before, 1e-9 * before);
}
