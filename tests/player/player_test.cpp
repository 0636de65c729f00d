#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "player/camera/navigation.h"
#include "player/camera/shots.h"
#include "player/plan/cluster_tree.h"
#include "player/plan/normal_clusters.h"
#include "player/plan/photo_cover.h"
#include "player/plan/sampling.h"
#include "player/plan/shown_tiles.h"
#include "player/plan/tile_needs.h"
#include "player/plan/weights.h"
#include "player/stream/layer_pool.h"
#include "scene/package_reader.h"
#include "scene/tiling.h"

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
            // Edge-on the levels run away.
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

TEST(TileNeeds, CoverTheRecordedExtent) {
    const package::PhotoRecord photo = photo_at({0, 0, -10}, Eigen::Matrix3d::Identity());
    package::ClusterRecord cluster = cluster_at({0, 0, 0}, 0.1);
    cluster.cone_axis[2] = -1;
    cluster.cone_cutoff = 0;
    const auto unorm = [](double pixel, double size) { return std::uint16_t(65535 * pixel / size); };
    package::CoverageRecord seen{65535, unorm(300, 1700), unorm(10, 1300), unorm(740, 1700), unorm(20, 1300),
                                 0};
    const View same = view_of_photo(photo, 1);
    const auto needed = [&](const View& view) {
        const LevelRange levels = sampled_levels(cluster, intrinsics(photo), cam_from_origin(photo), view, 1);
        return tile_needs(photo, std::vector{seen}, std::vector{ClusterLevels{0, levels}});
    };
    TileNeeds needs = needed(same);
    EXPECT_EQ(needs.color[0], (std::vector<std::uint32_t>{1, 2})) << "columns of 248 px";
    EXPECT_EQ(needs.masks[1], (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(needs.masks[0].empty());
    const View far = view_towards({0, 0, -160}, {0, 0, 0}, {0, -1, 0}, 45, 640, 480);
    needs = needed(far);
    EXPECT_TRUE(needs.color[0].empty());
    EXPECT_EQ(needs.color[photo.levels - 1].size(), 1u);
    seen.seen = 0;
    EXPECT_EQ(needed(same).tiles(), 0u);
}

/// Samples of the plane z = 0 under every `step`-th pixel of a view, between the given columns.
std::vector<SurfaceSample> plane_samples(const View& view, int step, int first, int end) {
    std::vector<SurfaceSample> out;
    const Intrinsics& k = view.intrinsics;
    const Eigen::Vector3d eye = view.cam_from_origin.center();
    for (int y = step / 2; y < k.height; y += step)
        for (int x = first + step / 2; x < end; x += step) {
            const Eigen::Vector3d ray = view.cam_from_origin.R.transpose() *
                                        Eigen::Vector3d((x + 0.5 - k.cx) / k.fx, (y + 0.5 - k.cy) / k.fy, 1);
            if (const auto s = surface_sample(view, eye - ray * (eye.z() / ray.z()), {0, 0, -1}, 1))
                out.push_back(*s);
        }
    return out;
}

TEST(ShownTiles, ContainTilesWithEnoughVisiblePixels) {
    const package::PhotoRecord photo = photo_at({0, 0, -10}, Eigen::Matrix3d::Identity());
    const auto needs = [&](const std::vector<SurfaceSample>& samples, double pixels) {
        return shown_tiles(photo, intrinsics(photo), cam_from_origin(photo), samples, pixels, 0.1);
    };
    // Through the photo's own eyes each pixel is a texel: of columns 0 to 268, tile 0 is full and 20 of
    // tile 1.
    const View own = view_of_photo(photo, 1);
    TileNeeds n = needs(plane_samples(own, 4, 0, 268), 16);
    EXPECT_EQ(n.color[0], (std::vector<std::uint32_t>{0, 7, 14, 21, 28, 35})) << "seven columns, six rows";
    EXPECT_TRUE(n.color[1].empty() || n.color[1].front() == 0) << "tile 1 is left to the next level";
    n = needs(plane_samples(own, 4, 0, 280), 16);
    EXPECT_EQ(n.color[0].size(), 11u)
        << "32 of 248 columns are more than a tenth, but in the last row, which is cut";
    // From four times as far two levels coarser, and masks with them.
    const View far = view_of_photo(photo_at({0, 0, -40}, Eigen::Matrix3d::Identity()), 1);
    n = needs(plane_samples(far, 4, 0, 1700), 16);
    EXPECT_TRUE(n.color[0].empty() && n.color[1].empty() && n.masks[1].empty());
    EXPECT_EQ(n.color[2].size(), 4u) << "425 x 325 texels";
    EXPECT_EQ(n.masks[2].size(), 4u);
    EXPECT_EQ(needs({}, 16).tiles(), 0u);
}

TEST(ShownTiles, EverySampleHasItsLevelOrACoarserOne) {
    Random random;
    for (int trial = 0; trial < 100; ++trial) {
        const View view = random_view(random), from = random_view(random);
        package::PhotoRecord photo = photo_at(from.cam_from_origin.center(), from.cam_from_origin.R);
        std::vector<SurfaceSample> samples;
        for (int i = 0; i < 200; ++i)
            if (const auto s = surface_sample(view, random.vector(1), random.vector(1).normalized(), 1))
                samples.push_back(*s);
        const TileNeeds n =
            shown_tiles(photo, intrinsics(photo), cam_from_origin(photo), samples, 50, random(0, 1));
        for (const SurfaceSample& s : samples) {
            const auto p = project(intrinsics(photo), cam_from_origin(photo), s.position);
            if (!p || p->pixel.x() < 0 || p->pixel.y() < 0 || p->pixel.x() >= photo.width ||
                p->pixel.y() >= photo.height)
                continue;
            const auto finds = [&](const auto& levels) {
                for (int l = 0; l < int(photo.levels); ++l) {
                    const Level size = level_size(int(photo.width), int(photo.height), l);
                    const int x = int(p->pixel.x() / (1 << l)) / tile_content,
                              y = int(p->pixel.y() / (1 << l)) / tile_content;
                    if (std::ranges::count(levels[std::size_t(l)], std::uint32_t(y * size.columns() + x)))
                        return true;
                }
                return false;
            };
            EXPECT_TRUE(finds(n.color) && finds(n.masks));
        }
    }
}

TEST(ClusterTree, FindsEveryClusterInTheFrustum) {
    Random random;
    std::vector<package::ClusterRecord> clusters;
    for (int i = 0; i < 700; ++i) clusters.push_back(cluster_at(random.vector(4), random(0.001, 0.3)));
    const ClusterTree tree = make_cluster_tree(clusters);
    std::size_t found = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const View view = random_view(random);
        const auto in_view = clusters_in_view(tree, clusters, view);
        EXPECT_TRUE(std::ranges::is_sorted(in_view));
        found += in_view.size();
        for (int i = 0; i < 2000; ++i) {
            const auto c = std::uint32_t(random(0, 699.99));
            const Eigen::Vector3d center(clusters[c].center[0], clusters[c].center[1], clusters[c].center[2]);
            const auto p = project(view.intrinsics, view.cam_from_origin,
                                   center + random.vector(1).normalized() * clusters[c].radius);
            if (p && p->pixel.x() >= 0 && p->pixel.y() >= 0 && p->pixel.x() < 640 && p->pixel.y() < 480) {
                EXPECT_TRUE(std::ranges::binary_search(in_view, c)) << "a visible cluster was dropped";
            }
        }
    }
    EXPECT_LT(found, 100u * 500) << "what is far out of view is left out";
    EXPECT_TRUE(clusters_in_view(make_cluster_tree({}), {}, random_view(random)).empty());
}

TEST(ClusterTree, DropsClustersBehindTheViewer) {
    const std::vector clusters{cluster_at({0, 0, 5}, 1)};
    const View away = view_towards({0, 0, 0}, {0, 0, -1}, {0, -1, 0}, 45, 640, 480);
    EXPECT_TRUE(clusters_in_view(make_cluster_tree(clusters), clusters, away).empty());
    EXPECT_EQ(depth_range(clusters, {}, away), Eigen::Vector2d(0, 0));
}

TEST(LayerPool, EvictsLeastRecentlyUsedButNothingInUse) {
    Random random;
    LayerPool pool(7, 40);
    std::vector<std::uint32_t> order;  // naive: most recent last
    std::vector<std::uint64_t> used(40, 0);
    for (std::uint64_t frame = 1; frame < 400; ++frame)
        for (int i = 0; i < 5; ++i) {
            const auto page = std::uint32_t(random(0, 39.99));
            const bool held = std::ranges::count(order, page) > 0;
            ASSERT_EQ(pool.layer_of(page).has_value(), held);
            if (held) {
                ASSERT_TRUE(pool.use(page, frame));
                std::erase(order, page);
            } else if (order.size() == 7) {
                if (used[order.front()] == frame) {
                    ASSERT_FALSE(pool.place(page, frame));
                    continue;
                }
                order.erase(order.begin());
                ASSERT_TRUE(pool.place(page, frame));
            } else {
                ASSERT_TRUE(pool.place(page, frame));
            }
            order.push_back(page);
            used[page] = frame;
            std::set<std::uint32_t> layers;
            for (const std::uint32_t p : order) layers.insert(*pool.layer_of(p));
            ASSERT_EQ(layers.size(), order.size()) << "two pages in one layer";
            ASSERT_EQ(pool.available(frame),
                      7 - std::ranges::count_if(order, [&](auto p) { return used[p] == frame; }));
        }
}

TEST(PhotoCover, LeavesAlmostNothingUncovered) {
    Random random;
    for (int trial = 0; trial < 50; ++trial) {
        const int triangles = 300, sets = 12;
        std::vector<std::vector<std::uint64_t>> whole(sets, std::vector<std::uint64_t>(5, 0)), part = whole;
        for (int s = 0; s < sets; ++s) {
            const int first = int(random(0, 250)), last = first + int(random(1, 80));
            for (int t = first; t < std::min(last, triangles); ++t) {
                part[std::size_t(s)][std::size_t(t / 64)] |= std::uint64_t(1) << (t % 64);
                if (t > first) whole[std::size_t(s)][std::size_t(t / 64)] |= std::uint64_t(1) << (t % 64);
            }
        }
        CoverProblem problem;
        for (std::uint32_t f = 0; f < 300; f += 60) problem.runs.push_back({f, 60, random(0.5, 2)});
        for (std::size_t s = 0; s < sets; ++s) problem.sets.push_back({whole[s], part[s], random(0.1, 1)});
        const auto chosen = cover(problem);
        EXPECT_LE(uncovered_share(problem, chosen), 1.6e-3);
        EXPECT_EQ(std::set(chosen.begin(), chosen.end()).size(), chosen.size());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            auto fewer = chosen;
            fewer.erase(fewer.begin() + std::ptrdiff_t(i));
            EXPECT_GT(uncovered_share(problem, fewer), 1.6e-3) << "one can be spared";
        }
    }
    EXPECT_TRUE(cover({}).empty());
    EXPECT_EQ(uncovered_share({}, {}), 0);
}

TEST(NormalClusters, RecoverKnownDirections) {
    Random random;
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<Eigen::Vector3d> truth, normals;
        while (truth.size() < 4) {
            const Eigen::Vector3d d = random.vector(1).normalized();
            if (std::ranges::all_of(truth, [&](const auto& t) { return t.dot(d) < 0.5; })) truth.push_back(d);
        }
        for (std::size_t i = 0; i < 1000; ++i)  // 100, 200, 300 and 400 of them
            normals.push_back((truth[i % 10 < 1   ? 0
                                     : i % 10 < 3 ? 1
                                     : i % 10 < 6 ? 2
                                                  : 3] +
                               random.vector(0.1))
                                  .normalized());
        const auto found = cluster_normals(normals, 4, 5);
        ASSERT_EQ(found.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(found[i].members, 400 - 100 * i);
            EXPECT_GT(found[i].direction.dot(truth[3 - i]), 0.99);
        }
    }
}

TEST(NormalClusters, DegenerateSets) {
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
    EXPECT_TRUE(cluster_normals({}, 4, 5).empty());
    const std::vector<Eigen::Vector3d> same(7, x), opposite{x, -x}, broken{x * std::nan(""), x};
    ASSERT_EQ(cluster_normals(same, 4, 5).size(), 1u) << "fewer than asked for";
    EXPECT_EQ(cluster_normals(same, 4, 5)[0].members, 7u);
    EXPECT_TRUE(cluster_normals(same, 0, 5).empty());
    for (const NormalCluster& c : cluster_normals(opposite, 1, 5)) EXPECT_NEAR(c.direction.norm(), 1, 1e-12);
    ASSERT_EQ(cluster_normals(broken, 2, 5).size(), 1u);
}

TEST(Weights, NearestIsOneAndNoneIsZero) {
    const auto w = nearest_is_one({2, 1, 3});
    EXPECT_DOUBLE_EQ(w[1], 1);
    EXPECT_DOUBLE_EQ(w[0], 0.5);
    EXPECT_GT(w[2], 0);
    EXPECT_EQ(nearest_is_one({5, 5, 5}), std::vector<double>(3, 1.0));
    EXPECT_TRUE(nearest_is_one({}).empty());
}

TEST(Weights, AreFiniteAtEveryExponent) {
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
            s.fov_normalization = per_photo;
            const auto w = dynamic_weights(view, photos, s);
            for (const double x : w) EXPECT_TRUE(x > 0 && x <= 1) << x;
            if (!per_photo) {
                EXPECT_DOUBLE_EQ(w.back(), 1) << "the photo at the viewpoint counts whole";
            }
        }
}

TEST(Weights, FieldOfViewMovesATelephotoCameraCloser) {
    // Two cameras on a line; the one with half the field of view sees from afar what the view sees from near.
    package::PhotoRecord wide = photo_at({0, 0, -10}, Eigen::Matrix3d::Identity());
    package::PhotoRecord tele = photo_at({0, 0, -20}, Eigen::Matrix3d::Identity());
    wide.seen_distance = 10;
    tele.seen_distance = 20;
    tele.fx = tele.fy = 2 * wide.fx;
    View view = view_of_photo(wide, 1);
    WeightSettings s;
    s.fov_normalization = true;
    const auto w = dynamic_weights(view, std::vector{wide, tele}, s);
    EXPECT_NEAR(w[1], 1, 1e-9) << "d' = d tan(f/2) / tan(f'/2) puts it on the view";
}

TEST(Navigation, StandsAtThePhotosCamera) {
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

TEST(Shots, FrameOfAnotherAspectRatioHoldsTheWholePhoto) {
    const package::PhotoRecord photo = photo_at({0, 0, 0}, Eigen::Matrix3d::Identity());
    const Shot exact = photo_shot(photo, std::nullopt, 0.5);
    EXPECT_EQ(exact.view.intrinsics.width, 850);
    EXPECT_DOUBLE_EQ(exact.view.intrinsics.cx, photo.cx / 2);
    const Shot framed = photo_shot(photo, FrameSize{3400, 1300}, 1);
    EXPECT_DOUBLE_EQ(framed.view.intrinsics.fx, photo.fx);
    EXPECT_DOUBLE_EQ(framed.view.intrinsics.cx, photo.cx + 850);
}
