#include "player/plan/coarse_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/player/test_scene.h"

using namespace vantage;

namespace {

/// A sphere of radius 1, in clusters of 100 triangles.
struct Sphere {
    std::vector<Eigen::Vector3f> positions;
    std::vector<std::uint32_t> indices;
    PlanScene scene;

    explicit Sphere(std::uint32_t rings) {
        const std::uint32_t around = 2 * rings;
        for (std::uint32_t r = 0; r <= rings; ++r)
            for (std::uint32_t a = 0; a < around; ++a) {
                const double polar = std::numbers::pi * r / rings, angle = 2 * std::numbers::pi * a / around;
                positions.emplace_back(float(std::sin(polar) * std::cos(angle)),
                                       float(std::sin(polar) * std::sin(angle)), float(std::cos(polar)));
            }
        for (std::uint32_t r = 0; r < rings; ++r)
            for (std::uint32_t a = 0; a < around; ++a) {
                const std::uint32_t i = r * around + a, next = r * around + (a + 1) % around;
                indices.insert(indices.end(), {i, i + around, next, next, i + around, next + around});
            }
        update();
    }
    void update() {
        scene.positions = positions;
        scene.indices = indices;
        scene.triangles = indices.size() / 3;
        scene.clusters.clear();
        for (std::size_t t = 0; t < scene.triangles; t += 100) {
            scene.clusters.push_back(cluster_at({0, 0, 0}, 1));
            scene.clusters.back().first_triangle = std::uint32_t(t);
            scene.clusters.back().triangles = std::uint32_t(std::min<std::size_t>(100, scene.triangles - t));
        }
    }
    Eigen::Vector3f middle(std::size_t triangle) const {
        const std::uint32_t* v = &indices[3 * triangle];
        return (positions[v[0]] + positions[v[1]] + positions[v[2]]) / 3;
    }
};

}  // namespace

TEST(CoarseMesh, IsNearTheMeshWithFarFewerTriangles) {
    const Sphere sphere(250);  // 250,000 triangles: in two parts
    const CoarseMesh coarse = make_coarse_mesh(sphere.scene, {});
    const std::size_t triangles = coarse.stands_for.size();
    ASSERT_EQ(coarse.indices.size(), 3 * triangles);
    EXPECT_LE(triangles, sphere.scene.triangles / 8 * 11 / 10);
    EXPECT_GT(triangles, sphere.scene.triangles / 16);
    EXPECT_LE(triangles, coarse_triangles(sphere.scene))
        << "more triangles than graphics memory is reserved for";
    EXPECT_LT(coarse.error, 0.01);
    double volume = 0;
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto corner = [&](std::size_t c) { return sphere.positions.at(coarse.indices[3 * t + c]); };
        const Eigen::Vector3f middle = (corner(0) + corner(1) + corner(2)) / 3;
        EXPECT_NEAR(middle.norm(), 1, 0.01);
        ASSERT_LT(coarse.stands_for[t], sphere.scene.triangles);
        EXPECT_LT((sphere.middle(coarse.stands_for[t]) - middle).norm(), 0.1)
            << "represents a distant triangle";
        volume += double(corner(0).dot(corner(1).cross(corner(2)))) / 6;
    }
    EXPECT_NEAR(std::abs(volume), 4.0 / 3 * std::numbers::pi, 0.02)
        << "the mesh has holes, or triangles face inward";
}

TEST(CoarseMesh, LeavesOutWhatIsNotOpaque) {
    Sphere sphere(250);
    sphere.scene.first_transparent = 1300;  // of 2500 clusters
    for (const std::uint32_t t : make_coarse_mesh(sphere.scene, {}).stands_for) EXPECT_LT(t, 130'000u);
    sphere.scene.first_transparent = ~0u;
    sphere.scene.first_surrounding = 1300;
    for (const std::uint32_t t : make_coarse_mesh(sphere.scene, {}).stands_for) EXPECT_LT(t, 130'000u);
}

TEST(CoarseMesh, SmallMeshesHaveNone) {
    const Sphere sphere(50);
    EXPECT_EQ(coarse_triangles(sphere.scene), 0u);
    EXPECT_TRUE(make_coarse_mesh(sphere.scene, {}).indices.empty());
    EXPECT_EQ(coarse_triangles(PlanScene{}), 0u);
}

TEST(CoarseMesh, VerticesOutOfRangeAndDegenerateTrianglesDoNoHarm) {
    Sphere sphere(250);
    for (std::size_t i = 0; i < sphere.indices.size(); i += 997) sphere.indices[i] = ~0u;
    for (std::size_t i = 0; i + 2 < sphere.indices.size(); i += 300)
        sphere.indices[i + 1] = sphere.indices[i];
    sphere.positions[77] = Eigen::Vector3f::Constant(NAN);
    sphere.update();
    const CoarseMesh coarse = make_coarse_mesh(sphere.scene, {});
    EXPECT_GT(coarse.stands_for.size(), 0u);
    for (const std::uint32_t v : coarse.indices) EXPECT_LT(v, sphere.positions.size());
    Sphere empty(250);
    std::ranges::fill(empty.indices, ~0u);
    EXPECT_TRUE(make_coarse_mesh(empty.scene, {}).indices.empty());
}

TEST(CoarseMesh, StopsWhenAsked) {
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(make_coarse_mesh(Sphere(250).scene, source.get_token()).indices.empty());
}
