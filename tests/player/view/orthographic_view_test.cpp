#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/text/error.h"
#include "player/plan/cluster_tree.h"
#include "player/view/view.h"
#include "tests/player/test_scene.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

struct Placed {
    View view;
    Vector3d middle, right, down;
    double pixels;
};

Placed random_placed(Random& random) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(random(0, 3), random.vector(1).normalized()).toRotationMatrix();
    Placed p{{}, random.vector(1), R.row(0), R.row(1), random(10, 300)};
    p.view = orthographic_view(p.middle, p.right, p.down, p.pixels, 8, {640, 480});
    p.view.intrinsics.cx = random(-300, 900);
    p.view.intrinsics.cy = random(-300, 900);
    return p;
}

/// Computed from the definition of an orthographic projection.
Eigen::Vector2d pixel_of(const Placed& p, const Vector3d& point) {
    return {p.view.intrinsics.cx + p.pixels * p.right.dot(point - p.middle),
            p.view.intrinsics.cy + p.pixels * p.down.dot(point - p.middle)};
}

}  // namespace

TEST(OrthographicView, ProjectsAtRightAngles) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Placed p = random_placed(random);
        const double depth = p.view.orthographic_depth;
        const Vector3d a = random.vector(3), b = random.vector(3), ahead = p.right.cross(p.down);
        const Eigen::Matrix4d clip = clip_from_origin(p.view, {depth - 10, depth + 10});
        const Eigen::Vector4d at = clip * a.homogeneous(), other = clip * b.homogeneous();
        EXPECT_NEAR(at.w(), 1, 1e-12);
        const Eigen::Vector2d expected = pixel_of(p, a);
        EXPECT_NEAR((at.x() + 1) / 2 * 640, expected.x(), 1e-6);
        EXPECT_NEAR((at.y() + 1) / 2 * 480, expected.y(), 1e-6);
        EXPECT_NEAR(at.z() - other.z(), -ahead.dot(a - b) / 20, 1e-9) << "greater depth values are nearer";
        // Computes in single precision, as for drawing.
        const Eigen::Vector4f drawn = clip.cast<float>() * a.cast<float>().homogeneous();
        EXPECT_NEAR((double(drawn.x()) + 1) / 2 * 640, expected.x(), 0.01);
    }
}

TEST(OrthographicView, ShowsWhatIsAtItsDepthAsPerspectiveDoes) {
    Random random;
    for (int i = 0; i < 100; ++i) {
        View view{{640, 480, random(100, 2000), random(100, 2000), random(0, 640), random(0, 480)}, {}};
        view.cam_from_origin.R =
            Eigen::AngleAxisd(random(0, 3), random.vector(1).normalized()).toRotationMatrix();
        view.cam_from_origin.t = random.vector(10);
        const double depth = random(0.1, 10);
        const View seen = orthographic(view, depth, 20);
        const Eigen::Vector3d in_camera(random(-3, 3), random(-3, 3), depth),
            point = view.cam_from_origin.R.transpose() * (in_camera - view.cam_from_origin.t),
            farther = point + random(0, 5) * view.cam_from_origin.direction();
        const auto expected = project(view.intrinsics, view.cam_from_origin, point);
        for (const Eigen::Vector3d& p : {point, farther}) {
            const Eigen::Vector4d at =
                clip_from_origin(seen, {seen.orthographic_depth - 30, seen.orthographic_depth + 30}) *
                p.homogeneous();
            EXPECT_NEAR((at.x() / at.w() + 1) / 2 * 640, expected->pixel.x(), 1e-5);
            EXPECT_NEAR((at.y() / at.w() + 1) / 2 * 480, expected->pixel.y(), 1e-5);
        }
    }
    EXPECT_THROW(orthographic({}, 0, 1), Error);
    EXPECT_THROW(orthographic({}, 1, 0), Error);
}

TEST(OrthographicView, FindsEveryClusterInIt) {
    Random random;
    std::vector<package::ClusterRecord> clusters;
    for (int i = 0; i < 700; ++i) clusters.push_back(cluster_at(random.vector(4), random(0.001, 0.3)));
    const ClusterTree tree = make_cluster_tree(clusters);
    std::size_t found = 0, inside = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Placed p = random_placed(random);
        const auto in_view = clusters_in_view(tree, clusters, p.view);
        found += in_view.size();
        const Eigen::Vector2d range = depth_range(clusters, in_view, p.view);
        for (std::uint32_t c = 0; c < 700; ++c) {
            const Vector3d center(clusters[c].center[0], clusters[c].center[1], clusters[c].center[2]);
            const Vector3d point = center + random.vector(1).normalized() * double(clusters[c].radius);
            if (!in_frame(p.view.intrinsics, pixel_of(p, point))) continue;
            ++inside;
            EXPECT_TRUE(std::ranges::binary_search(in_view, c));
            const double z = (p.view.cam_from_origin.R * point + p.view.cam_from_origin.t).z();
            EXPECT_TRUE(z >= range.x() && z <= range.y());
        }
        EXPECT_TRUE(in_view.empty() || range.y() - range.x() < 20)
            << "the depth range covers only the clusters";
    }
    EXPECT_GT(inside, 500u);
    EXPECT_LT(found, 100u * 500);
}

TEST(OrthographicView, RefusesNumbersThatAreNone) {
    const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
    EXPECT_THROW(orthographic_view({0, 0, 0}, x, y, 0, 1, {10, 10}), Error);
    EXPECT_THROW(orthographic_view({0, 0, 0}, x, y, 1, 0, {10, 10}), Error);
    EXPECT_THROW(orthographic_view({0, 0, 0}, x, y, 1e308, 10, {10, 10}), Error);
    EXPECT_THROW(orthographic_view(Vector3d::Constant(NAN), x, y, 1, 1, {10, 10}), Error);
}
