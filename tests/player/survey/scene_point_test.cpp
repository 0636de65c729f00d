#include "player/survey/scene_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>

#include "tests/player/survey/mesh_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

const Vector3d origin(450000, 5400000, 100);  // of the input's coordinates, as in map projections

Eigen::Vector2d pixel_of(const View& view, const Vector3d& p) {
    return project(view.intrinsics, view.cam_from_origin, p)->pixel;
}

}  // namespace

TEST(ScenePoint, IsInTheCoordinatesOfTheFirstInput) {
    MeshScene near, far;
    near.add_quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    near.finish();
    far.add_quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0});
    far.finish();
    far.add_photo(view_towards({0, 0, -10}, {0, 0, 0}, {0, 1, 0}, 45, 1000, 1000).cam_from_origin, 1000);
    // The second mesh is rotated by a quarter turn about z and scaled by three, and lies 5 behind the first
    // mesh.
    const Eigen::Matrix3d R = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()).toRotationMatrix();
    const std::array<PlacedMesh, 2> meshes{PlacedMesh{&near.scene}, PlacedMesh{&far.scene, R, {0, 0, 5}, 3}};
    const View view = view_towards({1, 2, -20}, {0, 0, 0}, {0, 1, 0}, 45, 800, 600);
    for (const Vector3d& p : {Vector3d(0.5, -0.5, 0), Vector3d(4, 3, 5), Vector3d(-3, 2, 5)}) {
        const auto point = scene_point(meshes, origin, view, pixel_of(view, p));
        ASSERT_TRUE(point);
        EXPECT_LT((point->position - origin - p).norm(), 1e-8);
        ASSERT_EQ(point->uncertainty.has_value(), p.z() == 5) << "the first mesh has no photos";
        EXPECT_NEAR(point->uncertainty.value_or(0.03), 3 * 0.01, 1e-9);
        const double pixel = (20 + p.z()) / view.intrinsics.fx;  // the view is slightly oblique
        EXPECT_NEAR(point->pointing, pixel / 2, 0.02 * pixel);
    }
    const View away = view_towards({0, 0, -20}, {0, 0, -30}, {0, 1, 0}, 45, 800, 600);
    EXPECT_FALSE(scene_point(meshes, origin, away, {400, 300}));
    EXPECT_FALSE(scene_point({}, origin, view, {400, 300}));
}

TEST(ScenePoint, SnapsToVerticesInSight) {
    MeshScene m;
    m.add_quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    m.add_quad({-2, -2, 3}, {2.9, 0, 0}, {0, 2.9, 0});  // its corner (0.9, 0.9, 3) is behind the other
    m.finish();
    const std::array<PlacedMesh, 1> meshes{PlacedMesh{&m.scene}};
    const View view = view_towards({0, 0, -20}, {0, 0, 0}, {0, -1, 0}, 45, 800, 600);
    const Vector3d corner(1, 1, 0), hidden(0.9, 0.9, 3);
    const Eigen::Vector2d at = pixel_of(view, corner);
    for (const auto& off :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(5, 4), Eigen::Vector2d(-6, -6), Eigen::Vector2d(3, -7)}) {
        const auto snapped = scene_point(meshes, Vector3d::Zero(), view, at + off, {{}, 10});
        ASSERT_TRUE(snapped) << off.transpose();
        EXPECT_LT((snapped->position - corner).norm(), 1e-6) << off.transpose();
        EXPECT_EQ(snapped->pointing, 0) << "the vertex is exact";
    }
    EXPECT_FALSE(scene_point(meshes, Vector3d::Zero(), view, at + Eigen::Vector2d(15, 15), {{}, 10}));
    const auto behind = scene_point(meshes, Vector3d::Zero(), view, pixel_of(view, hidden), {{}, 2});
    ASSERT_TRUE(behind);
    EXPECT_NEAR(behind->position.z(), 0, 1e-9) << "the point is on the surface in front of the hidden vertex";
    const auto unsnapped = scene_point(meshes, Vector3d::Zero(), view, at - Eigen::Vector2d(5, 5));
    ASSERT_TRUE(unsnapped);
    EXPECT_GT((unsnapped->position - corner).norm(), 0.05);
}
