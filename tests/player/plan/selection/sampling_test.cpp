#include "player/plan/selection/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scene/package/package_reader.h"
#include "tests/player/test_scene.h"

using namespace vantage;

namespace {

/// The level of detail at a point, from finite differences on the plane through that point; 99 if undefined.
double sampled_lod(const package::PhotoRecord& photo, const View& view, const Eigen::Vector3d& point,
                   const Eigen::Vector3d& normal) {
    const auto pixel_of = [&](const Eigen::Vector3d& p) {
        return project(intrinsics(photo), cam_from_origin(photo), p);
    };
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    const auto at = project(view.intrinsics, view.cam_from_origin, point);
    double lengths[2];
    for (int axis = 0; axis < 2; ++axis) {
        Eigen::Vector2d moved = at->pixel;
        moved[axis] += 1e-3;
        const Intrinsics& k = view.intrinsics;
        const Eigen::Vector3d ray = view.cam_from_origin.R.transpose() *
                                    Eigen::Vector3d((moved.x() - k.cx) / k.fx, (moved.y() - k.cy) / k.fy, 1);
        const Eigen::Vector3d hit = eye + ray * (normal.dot(point - eye) / normal.dot(ray));
        const auto a = pixel_of(point), b = pixel_of(hit);
        if (!a || !b) return 99;
        lengths[axis] = (b->pixel - a->pixel).norm() / 1e-3;
    }
    const double major = std::max(lengths[0], lengths[1]), minor = std::min(lengths[0], lengths[1]);
    return std::max(0.0, std::log2(std::max(minor, major / 4)) - 0.02);
}

}  // namespace

TEST(SampledLevels, ContainTheLevelOfEveryFragment) {
    Random random;
    int looked = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const View view = random_view(random), from = random_view(random);
        const package::PhotoRecord photo = photo_at(from.cam_from_origin.center(), from.cam_from_origin.R);
        const Eigen::Vector3d center = random.vector(1), axis = random.vector(1).normalized();
        const double radius = random(0.01, 0.1), half_angle = random(0.01, 0.4);
        package::ClusterRecord cluster = cluster_at(center, radius * 1.001);
        for (int i = 0; i < 3; ++i) cluster.cone_axis[i] = float(axis[i]);
        cluster.cone_cutoff = float(std::sin(half_angle));
        const LevelRange range = sampled_levels(cluster, intrinsics(photo), cam_from_origin(photo), view, 1);
        for (int i = 0; i < 50; ++i) {
            const Eigen::Vector3d point = center + random.vector(1).normalized() * random(0, radius);
            const Eigen::Vector3d tilt = axis.cross(random.vector(1)).normalized();
            const Eigen::Vector3d normal = Eigen::AngleAxisd(random(0, half_angle), tilt) * axis;
            const Eigen::Vector3d eye = view.cam_from_origin.center(),
                                  camera = cam_from_origin(photo).center();
            const double to_view = normal.dot((eye - point).normalized()),
                         to_photo = normal.dot((camera - point).normalized());
            // Levels diverge if the surface is seen edge-on.
            if (to_view < 0.2 || to_photo < 0.6 || normal.dot(axis) < std::cos(half_angle)) continue;
            if (!project(view.intrinsics, view.cam_from_origin, point)) continue;
            const double lod = sampled_lod(photo, view, point, normal);
            if (lod == 99) continue;
            EXPECT_GE(lod, range.finest - 0.35) << trial;
            EXPECT_LE(lod, range.coarsest + 0.5) << trial;
            ++looked;
        }
    }
    EXPECT_GT(looked, 500);
}
