#include "scene/camera/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/text/error.h"

using namespace vantage;

namespace {
const Intrinsics photo{1200, 800, 1000, 1010, 590.5, 411.25};
Pose looking(double angle) {
    return {Eigen::AngleAxisd(angle, Eigen::Vector3d(0.2, 1, 0.1).normalized()).toRotationMatrix(),
            {0.3, -0.2, 4}};
}
}  // namespace

TEST(Camera, ProjectsTheCenterRayOntoThePrincipalPoint) {
    const Pose pose = looking(0.4);
    const auto p = project(photo, pose, pose.center() + 3 * pose.direction());
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->pixel.x(), photo.cx, 1e-9);
    EXPECT_NEAR(p->pixel.y(), photo.cy, 1e-9);
    EXPECT_NEAR(p->z, 3, 1e-12);
}

TEST(Camera, DoesNotProjectPointsBehindOrAtTheCamera) {
    const Pose pose = looking(0.4);
    EXPECT_FALSE(project(photo, pose, pose.center() - pose.direction()));
    EXPECT_FALSE(project(photo, pose, pose.center()));
    EXPECT_FALSE(project(photo, pose, Eigen::Vector3d::Constant(std::nan(""))));
}

TEST(Camera, ClipMatrixAgreesWithProjectionOnEveryPixel) {
    const Pose pose = looking(-0.7);
    const Eigen::Matrix4d clip = clip_from_cam(photo, 0.5, 50);
    for (const Eigen::Vector3d& x :
         {Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d(-1, 0.5, 1), Eigen::Vector3d(0, 0, 0)}) {
        const Eigen::Vector4d c = clip * (pose.R * x + pose.t).homogeneous();
        const auto p = project(photo, pose, x);
        EXPECT_NEAR((c.x() / c.w() + 1) / 2 * photo.width, p->pixel.x(), 1e-9);
        EXPECT_NEAR((c.y() / c.w() + 1) / 2 * photo.height, p->pixel.y(), 1e-9);
    }
    EXPECT_NEAR((clip * Eigen::Vector4d(0, 0, 0.5, 1)).hnormalized().z(), 1, 1e-12);
    EXPECT_NEAR((clip * Eigen::Vector4d(0, 0, 50, 1)).hnormalized().z(), 0, 1e-12);
}

TEST(Camera, KeepsPrecisionFarFromTheOrigin) {
    const Eigen::Vector3d origin(4e5, 5.4e6, 300);
    Pose pose = looking(0.2);
    pose.t = -pose.R * (origin + Eigen::Vector3d(1, 2, -9));
    const Eigen::Vector3d local(0.25, -0.5, 0.125);
    const auto far = project(photo, pose, origin + local),
               near = project(photo, pose.relative_to(origin), local);
    EXPECT_NEAR((far->pixel - near->pixel).norm(), 0, 1e-5);
}

TEST(Camera, RejectsInvalidCameras) {
    Camera mirrored{photo, {}, looking(0.1)};
    mirrored.cam_from_world.R.row(0) *= -1;
    EXPECT_THROW(validate(mirrored, "mirrored"), Error);
    Camera flat{photo, {}, looking(0.1)};
    flat.intrinsics.fx = 0;
    EXPECT_THROW(validate(flat, "flat"), Error);
    Camera good{photo, {}, looking(0.1)};
    EXPECT_NO_THROW(validate(good, "good"));
}

TEST(Lens, IsContinuousAndFiniteAtTheCenter) {
    for (const LensModel m :
         {LensModel::none, LensModel::opencv, LensModel::fisheye, LensModel::fov, LensModel::thin_prism}) {
        const Lens lens{m, {0.1, -0.05, 0.001, 0.002, 0.01, 0, 0, 0}};
        const Eigen::Vector2d at = distort(lens, {0, 0}), beside = distort(lens, {1e-7, 1e-7});
        EXPECT_TRUE(at.allFinite() && beside.allFinite()) << name(m);
        EXPECT_LT((at - beside).norm(), 1e-6) << name(m);
    }
}
