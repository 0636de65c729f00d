#include "player/survey/ray_cast.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "player/survey/footprint.h"
#include "tests/player/survey/mesh_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

/// Small triangles spread over a cube.
MeshScene heap(int triangles) {
    MeshScene m;
    Random random;
    for (int i = 0; i < triangles; ++i) {
        const Vector3d at = random.vector(2);
        m.add(at, at + random.vector(0.3), at + random.vector(0.3));
    }
    m.finish();
    return m;
}

/// The distance of the nearest triangle, found by solving the equations of all triangles.
double nearest_of_all(const MeshScene& m, const Ray& ray) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < m.scene.triangles; ++t) {
        const auto corner = m.triangle(t);
        Eigen::Matrix3d columns;
        columns << corner[1] - corner[0], corner[2] - corner[0], -ray.along;
        const Vector3d x = columns.fullPivLu().solve(ray.from - corner[0]);
        if (x.x() >= 0 && x.y() >= 0 && x.x() + x.y() <= 1 && x.z() >= 0) nearest = std::min(nearest, x.z());
    }
    return nearest;
}

}  // namespace

TEST(RayCast, FindsTheNearestTriangle) {
    const MeshScene m = heap(3000);
    Random random;
    int hits = 0;
    for (int i = 0; i < 300; ++i) {
        const Ray ray{random.vector(4), random.vector(1)};
        const double expected = nearest_of_all(m, ray);
        const auto hit = first_hit(m.scene, ray);
        ASSERT_EQ(hit.has_value(), std::isfinite(expected)) << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(hit->distance, expected, 1e-9);
        EXPECT_LT((hit->position - (ray.from + ray.along * expected)).norm(), 1e-9);
    }
    EXPECT_GT(hits, 60);
}

TEST(RayCast, FindsWhatAPixelShows) {
    const MeshScene m = heap(2000);
    Random random;
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
        const View view = random_view(random);
        const Eigen::Vector2d pixel(random(0, 640), random(0, 480));
        const auto hit = first_hit(m.scene, ray_through(view, pixel));
        if (!hit) continue;
        const auto shown = project(view.intrinsics, view.cam_from_origin, hit->position);
        ASSERT_TRUE(shown);
        EXPECT_LT((shown->pixel - pixel).norm(), 1e-6);
        ++hits;
    }
    EXPECT_GT(hits, 40);
}

TEST(RayCast, MissesBackgroundAndWhatIsOutOfRange) {
    MeshScene m;
    m.add_quad({-1, -1, 5}, {2, 0, 0}, {0, 2, 0});
    m.finish();
    const Ray ray{Vector3d::Zero(), {0, 0, 1}};
    EXPECT_TRUE(first_hit(m.scene, ray));
    EXPECT_FALSE(first_hit(m.scene, ray, {0, 4.9}));
    EXPECT_FALSE(first_hit(m.scene, ray, {5.1, 10}));
    EXPECT_FALSE(first_hit(m.scene, {Vector3d::Zero(), {0, 0, -1}})) << "behind the viewer";
    m.scene.first_surrounding = 0;
    EXPECT_FALSE(first_hit(m.scene, ray));
}

TEST(RayCast, MissesWithRaysThatAreNone) {
    MeshScene m;
    m.add_quad({-1, -1, 5}, {2, 0, 0}, {0, 2, 0});
    m.add({1, 1, 1}, {1, 1, 1}, {1, 1, 1});  // a point
    m.add({0, 0, 2}, {0, 0, 3}, {0, 0, 4});  // on the ray
    m.finish();
    const double none = std::numeric_limits<double>::quiet_NaN(),
                 far = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(first_hit(m.scene, {Vector3d::Zero(), Vector3d::Zero()}));
    EXPECT_FALSE(first_hit(m.scene, {Vector3d::Zero(), {0, none, 1}}));
    EXPECT_FALSE(first_hit(m.scene, {{far, 0, 0}, {0, 0, 1}}));
    const auto hit = first_hit(m.scene, {Vector3d::Zero(), {0, 0, 1}});
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->distance, 5);
    EXPECT_FALSE(first_hit(PlanScene{}, {Vector3d::Zero(), {0, 0, 1}}));
}

TEST(Footprint, IsThatOfTheFinestPhotoThatSeesThePoint) {
    MeshScene m;
    m.add_quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
    m.add_quad({-1, -1, -3}, {2, 0, 0}, {0, 2, 0});  // occludes the middle in the photo in front of it
    m.finish();
    const auto at = [](double x, double y, double z) {
        return view_towards({x, y, z}, {x, y, 0}, {0, 1, 0}, 45, 1000, 1000).cam_from_origin;
    };
    m.add_photo(at(0, 0, -10), 2000);  // finest; sees the quad in front only
    m.add_photo(at(4, 0, -10), 1000);
    m.add_photo(at(0, 0, 20), 1000);  // from behind
    const auto seen = smallest_footprint(m.scene, 0, {0, 0, 0});
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->photo, 1u);
    EXPECT_NEAR(seen->size, 10 / 1000.0, 1e-12);
    const auto on_front = smallest_footprint(m.scene, 2, {0, 0, -3});
    ASSERT_TRUE(on_front);
    EXPECT_EQ(on_front->photo, 0u);
    EXPECT_NEAR(on_front->size, 7 / 2000.0, 1e-12);
    const std::vector<Footprint> all = footprints(m.scene, 0, {0, 0, 0});
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.front().photo, seen->photo);
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, &Footprint::size));
    EXPECT_TRUE(footprints(m.scene, 0, {100, 100, 0}).empty());
    EXPECT_FALSE(smallest_footprint(m.scene, 0, {100, 100, 0})) << "the point is in no photo's frame";
    EXPECT_FALSE(smallest_footprint(m.scene, 12345, {0, 0, 0}));
}
