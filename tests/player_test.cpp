#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "player/navigation.h"
#include "player/shots.h"
#include "player/tile_needs.h"
#include "player/weights.h"
#include "scene/package_reader.h"

using namespace vantage;

namespace {

package::PhotoRecord photo_at(const Eigen::Vector3d& center, const Eigen::Matrix3d& R, int width = 1700,
                              int height = 1300) {
    package::PhotoRecord p{};
    p.width = std::uint32_t(width);
    p.height = std::uint32_t(height);
    p.fx = p.fy = 1500;
    p.cx = 830;
    p.cy = 670;
    p.levels = std::uint32_t(level_count(width, height));
    p.seen_distance = 10;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(p.R) = R;
    Eigen::Map<Eigen::Vector3d>(p.t) = -R * center;
    return p;
}

struct Random {
    std::mt19937 engine{7};
    double operator()(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    Eigen::Vector3d vector(double size) {
        return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
    }
};

package::ClusterRecord cluster_at(const Eigen::Vector3d& c, double r) {
    package::ClusterRecord cluster{};
    for (int i = 0; i < 3; ++i) cluster.center[i] = float(c[i]);
    cluster.radius = float(r);
    return cluster;
}

/// A camera a few units from the origin that looks roughly at it.
View random_view(Random& random) {
    const Eigen::Vector3d eye = random.vector(1).normalized() * random(2, 12);
    return view_towards(eye, random.vector(1), Eigen::Vector3d(0, 0, 1), random(20, 90), 640, 480);
}

/// The finest of two samples' distances in photo pixels, by finite differences on a plane through the point.
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

TEST(TileNeeds, HoldEveryTileThatAFragmentSamples) {
    Random random;
    int looked = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const View view = random_view(random), from = random_view(random);
        const package::PhotoRecord photo = photo_at(from.cam_from_origin.center(), from.cam_from_origin.R);
        const Eigen::Vector3d center = random.vector(1);
        const double radius = random(0.01, 0.5);
        const std::vector clusters{cluster_at(center, radius * 1.001)};
        const auto in_view = clusters_in_view(clusters, view);
        const TileNeeds needs = tile_needs(photo, clusters, {}, in_view, view, 1);
        for (int i = 0; i < 200; ++i) {
            const Eigen::Vector3d point = center + random.vector(1).normalized() * random(0, radius);
            const auto seen = project(view.intrinsics, view.cam_from_origin, point);
            const auto taken = project(intrinsics(photo), cam_from_origin(photo), point);
            const auto within = [](const auto& p, double w, double h) {
                return p && p->pixel.x() >= 0 && p->pixel.y() >= 0 && p->pixel.x() < w && p->pixel.y() < h;
            };
            if (!within(seen, 640, 480)) continue;
            EXPECT_EQ(in_view.size(), 1u) << "a cluster in view was dropped";
            if (!within(taken, photo.width, photo.height)) continue;
            // A surface that photo and view both see, at up to 60 degrees from the photo's ray.
            const Eigen::Vector3d to_photo = (cam_from_origin(photo).center() - point).normalized();
            const Eigen::Vector3d normal = (to_photo + random.vector(0.5)).normalized();
            if (normal.dot(to_photo) < 0.5 || normal.dot(view.cam_from_origin.center() - point) <= 0)
                continue;
            const int level = std::min(int(sampled_lod(photo, view, point, normal)), int(photo.levels) - 1);
            const Level size = level_size(int(photo.width), int(photo.height), level);
            const Eigen::Vector2d texel = taken->pixel / double(1 << level);
            const auto tile =
                std::uint32_t(int(texel.y() / tile_content) * size.columns() + int(texel.x() / tile_content));
            EXPECT_TRUE(std::ranges::binary_search(needs.color[std::size_t(level)], tile))
                << "trial " << trial << " level " << level;
            ++looked;
        }
    }
    EXPECT_GT(looked, 500);
}

TEST(TileNeeds, AreFewFromFarAway) {
    const Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    const package::PhotoRecord photo = photo_at({0, 0, -10}, R);
    const std::vector clusters{cluster_at({0, 0, 0}, 1)};
    const View far = view_towards({0, 0, -1000}, {0, 0, 0}, {0, -1, 0}, 45, 640, 480);
    const auto needs = tile_needs(photo, clusters, {}, clusters_in_view(clusters, far), far, 1);
    EXPECT_TRUE(needs.color[0].empty());
    EXPECT_EQ(needs.color[photo.levels - 1].size(), 1u) << "the coarsest level always stands in";
}

TEST(TileNeeds, NothingBehindTheViewer) {
    const std::vector clusters{cluster_at({0, 0, 5}, 1)};
    const View away = view_towards({0, 0, 0}, {0, 0, -1}, {0, -1, 0}, 45, 640, 480);
    EXPECT_TRUE(clusters_in_view(clusters, away).empty());
    EXPECT_EQ(depth_range(clusters, away), Eigen::Vector2d(0, 0));
}

TEST(Weights, NearestIsOneAndNobodyIsZero) {
    const auto w = nearest_is_one({2, 1, 3});
    EXPECT_DOUBLE_EQ(w[1], 1);
    EXPECT_DOUBLE_EQ(w[0], 0.5);
    EXPECT_GT(w[2], 0);
    EXPECT_EQ(nearest_is_one({5, 5, 5}), std::vector<double>(3, 1.0));
    EXPECT_TRUE(nearest_is_one({}).empty());
}

TEST(Weights, FiniteAtEveryExponent) {
    Random random;
    const View view = random_view(random);
    std::vector<package::PhotoRecord> photos;
    for (int i = 0; i < 5; ++i) {
        const View v = random_view(random);
        photos.push_back(photo_at(v.cam_from_origin.center(), v.cam_from_origin.R));
    }
    photos.push_back(photo_at(view.cam_from_origin.center(), view.cam_from_origin.R));
    for (const double exponent : {0.0, 1.0, 64.0})
        for (const bool per_photo : {false, true}) {
            WeightSettings s;
            s.exponent = exponent;
            s.angle_per_photo = per_photo;
            s.fov_normalisation = per_photo;
            const auto w = dynamic_weights(view, photos, s);
            for (const double x : w) EXPECT_TRUE(x > 0 && x <= 1) << x;
            if (!per_photo) {
                EXPECT_DOUBLE_EQ(w.back(), 1) << "the photo at the viewpoint counts whole";
            }
        }
}

TEST(Weights, FieldOfViewMovesAWideAngleCameraCloser) {
    // Two cameras on a line; the one with half the field of view sees from afar what the view sees from near.
    package::PhotoRecord wide = photo_at({0, 0, -10}, Eigen::Matrix3d::Identity());
    package::PhotoRecord tele = photo_at({0, 0, -20}, Eigen::Matrix3d::Identity());
    wide.seen_distance = 10;
    tele.seen_distance = 20;
    tele.fx = tele.fy = 2 * wide.fx;
    View view = view_of_photo(wide, 1);
    WeightSettings s;
    s.fov_normalisation = true;
    const auto w = dynamic_weights(view, std::vector{wide, tele}, s);
    EXPECT_NEAR(w[1], 1, 1e-9) << "d' = d tan(f/2) / tan(f'/2) puts it on the view";
}

TEST(Navigation, StandsWhereThePhotoWasTaken) {
    Random random;
    const View v = random_view(random);
    const package::PhotoRecord photo = photo_at(v.cam_from_origin.center(), v.cam_from_origin.R);
    const Navigation n = stand_at(photo, {0, 0, 1});
    EXPECT_TRUE(view_of(n, 100, 100).cam_from_origin.R.isApprox(v.cam_from_origin.R, 1e-12));
    EXPECT_NEAR((n.target - n.eye).norm(), photo.seen_distance, 1e-9);
}

TEST(Navigation, OrbitKeepsDistanceAndStopsAtThePoles) {
    Random random;
    const View v = random_view(random);
    Navigation n = stand_at(photo_at(v.cam_from_origin.center(), v.cam_from_origin.R), {0, 0, 1});
    const double distance = (n.eye - n.target).norm();
    for (int i = 0; i < 500; ++i) {
        orbit(n, random(-1, 1), random(-2, 1));
        EXPECT_NEAR((n.eye - n.target).norm(), distance, 1e-6);
        EXPECT_TRUE((n.R * n.R.transpose()).isIdentity(1e-6));
        EXPECT_LT((n.target - n.eye).normalized().cross(Eigen::Vector3d(n.R.row(2))).norm(), 1e-6);
        EXPECT_LT(std::abs(n.R.row(2).dot(n.up)), 0.99999) << "past a pole left and right change places";
    }
}

TEST(Shots, AFrameOfAnotherShapeHoldsTheWholePhoto) {
    const package::PhotoRecord photo = photo_at({0, 0, 0}, Eigen::Matrix3d::Identity());
    const Shot exact = photo_shot(photo, std::nullopt, 0.5);
    EXPECT_EQ(exact.view.intrinsics.width, 850);
    EXPECT_DOUBLE_EQ(exact.view.intrinsics.cx, photo.cx / 2);
    const Shot framed = photo_shot(photo, FrameSize{3400, 1300}, 1);
    EXPECT_DOUBLE_EQ(framed.view.intrinsics.fx, photo.fx);
    EXPECT_DOUBLE_EQ(framed.view.intrinsics.cx, photo.cx + 850);
}
