#include "player/composition/object_view.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

using namespace vantage;
using Eigen::Vector3d;

namespace {

double number(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
}
Vector3d vector(std::mt19937& random, double reach) {
    return Vector3d::NullaryExpr([&] { return number(random, -reach, reach); });
}

Vector3d in_camera(const View& view, const Vector3d& p) {
    return view.cam_from_origin.R * p + view.cam_from_origin.t;
}

}  // namespace

TEST(Placement, ShowsAPlacedPointWhereTheSceneHasIt) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vector3d scene_origin = vector(random, 100), object_origin = vector(random, 100);
        const Placement p{vector(random, 10), vector(random, 180), number(random, 0.01, 5)};
        View view;
        view.intrinsics = {640, 480, 500, 510, 320, 240};
        view.cam_from_origin.R = rotation_of({{}, vector(random, 180), 1});
        view.cam_from_origin.t = vector(random, 20);
        const View of_object = view_of_object(view, scene_origin, object_origin, p);
        const Vector3d local = vector(random, 5);  // relative to the object's origin
        const Vector3d placed = object_origin + p.move + p.scale * (rotation_of(p) * local);
        const Vector3d expected = in_camera(view, placed - scene_origin);
        EXPECT_LT((p.scale * in_camera(of_object, local) - expected).norm(), 1e-9 * (1 + expected.norm()));
        const Eigen::Matrix3d& R = of_object.cam_from_origin.R;
        EXPECT_TRUE((R * R.transpose()).isIdentity(1e-12));
    }
}

TEST(Placement, TurnsAboutXThenYThenZ) {
    // A quarter turn about x maps y to z, and the subsequent quarter turn about z does not change the vector.
    EXPECT_TRUE((rotation_of({{}, {90, 0, 90}, 1}) * Vector3d::UnitY()).isApprox(Vector3d::UnitZ(), 1e-12));
    EXPECT_TRUE((rotation_of({{}, {90, 0, 90}, 1}) * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-12));
    EXPECT_TRUE((rotation_of({{}, {0, 90, 0}, 1}) * Vector3d::UnitZ()).isApprox(Vector3d::UnitX(), 1e-12));
}
