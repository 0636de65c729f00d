// Tests the selection of photos that cover a view, and frustum culling: degenerate cases, and planes that
// just touch a sphere.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "pipeline/mesh/clusters.h"
#include "player/plan/cluster_tree.h"
#include "player/plan/plan.h"
#include "player/plan/selection/photo_cover.h"
#include "tests/hard_cases/special_numbers.h"

using namespace vantage;
using package::ClusterRecord;

namespace {

Eigen::Vector3d random_unit(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

double random_in(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// This function must not be inlined, because GCC 12 would vectorize it and skip the rounding to single
/// precision.
[[gnu::noinline]] ClusterRecord sphere(const Eigen::Vector3d& c, double r) {
    ClusterRecord cluster{};
    for (int i = 0; i < 3; ++i) cluster.center[i] = float(c[i]);
    cluster.radius = float(r);
    return cluster;
}

bool holds(const std::vector<std::uint32_t>& list, std::uint32_t i) {
    return std::ranges::binary_search(list, i);
}

View random_view(std::mt19937& random, double fov) {
    return view_towards(10 * random_unit(random), random_unit(random), random_unit(random), fov, 640, 480);
}

/// The signed distance from the nearest of the frustum's five planes to a point (positive inside the
/// frustum), in long double.
long double inside_by(const View& view, const Eigen::Vector3d& point) {
    using V = Eigen::Matrix<long double, 3, 1>;
    const Intrinsics& k = view.intrinsics;
    const V p = view.cam_from_origin.R.cast<long double>() * point.cast<long double>() +
                view.cam_from_origin.t.cast<long double>();
    long double least = p.z();
    for (const auto& n :
         {V(k.fx, 0, k.cx), V(-k.fx, 0, k.width - k.cx), V(0, k.fy, k.cy), V(0, -k.fy, k.height - k.cy)})
        least = std::min(least, n.normalized().dot(p));
    return least;
}

}  // namespace

namespace {

struct Bits {
    std::vector<std::vector<std::uint64_t>> whole, part;
    CoverProblem problem;
};

/// Random sets over `triangles`; no photo sees the triangles of the last cluster.
Bits random_cover(std::mt19937& random, std::uint32_t triangles, std::size_t sets) {
    Bits b;
    const std::size_t words = package::visible_words(triangles);
    b.whole.assign(sets, std::vector<std::uint64_t>(words, 0));
    b.part = b.whole;
    for (std::size_t s = 0; s < sets; ++s)
        for (std::uint32_t t = 0; t < triangles * 3 / 4; ++t) {
            const unsigned r = random() % 8;
            if (r < 3) b.part[s][t / 64] |= std::uint64_t(1) << (t % 64);
            if (r < 2) b.whole[s][t / 64] |= std::uint64_t(1) << (t % 64);
        }
    const std::uint32_t quarter = triangles / 4;
    for (std::uint32_t c = 0; c < 4; ++c) b.problem.runs.push_back({c * quarter, quarter, 1});
    for (std::size_t s = 0; s < sets; ++s) b.problem.sets.push_back({b.whole[s], b.part[s], 1});
    return b;
}

/// The value of uncovered_share(), computed from its definition, triangle by triangle.
double counted_share(const CoverProblem& p, const std::vector<std::size_t>& chosen) {
    const auto seen = [](const auto& bits, std::uint32_t t) { return bits[t / 64] >> (t % 64) & 1; };
    double all = 0, left = 0;
    for (const CoverProblem::Run& run : p.runs)
        for (std::uint32_t t = run.first; t < run.first + run.count; ++t) {
            bool whole = false, part = false, got_whole = false, got_part = false;
            for (std::size_t s = 0; s < p.sets.size(); ++s) {
                const bool is = std::ranges::count(chosen, s) > 0;
                whole |= seen(p.sets[s].whole, t), got_whole |= is && seen(p.sets[s].whole, t);
                part |= seen(p.sets[s].part, t), got_part |= is && seen(p.sets[s].part, t);
            }
            all += run.area * (0.25 * whole + part);
            left += run.area * (0.25 * (whole && !got_whole) + (part && !got_part));
        }
    return all > 0 ? left / all : 0;
}

}  // namespace

// Clusters that no photo sees must not prolong the search.
TEST(PhotoCoverHardCases, CoversAllTrianglesThatSomePhotoSees) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 80; ++trial) {
        const auto triangles = std::uint32_t(4 * (1 + random() % 40));
        const Bits b = random_cover(random, triangles, 1 + random() % 9);
        const auto chosen = cover(b.problem);
        EXPECT_LE(uncovered_share(b.problem, chosen), 1.6e-3) << "trial " << trial;
        EXPECT_NEAR(uncovered_share(b.problem, chosen), counted_share(b.problem, chosen), 1e-12);
        std::vector<std::size_t> some(chosen.begin(), chosen.begin() + std::ptrdiff_t(chosen.size() / 2));
        EXPECT_NEAR(uncovered_share(b.problem, some), counted_share(b.problem, some), 1e-12);
    }
}

TEST(PhotoCoverHardCases, TakesAtMostTwoMoreThanTheMinimum) {
    std::mt19937 random(4);
    for (int trial = 0; trial < 40; ++trial) {
        const Bits b = random_cover(random, 48, 8);
        const auto chosen = cover(b.problem);
        std::size_t fewest = 8;
        for (unsigned subset = 0; subset < 256; ++subset) {
            std::vector<std::size_t> of;
            for (std::size_t s = 0; s < 8; ++s)
                if (subset >> s & 1) of.push_back(s);
            if (of.size() < fewest && counted_share(b.problem, of) <= 1.6e-3) fewest = of.size();
        }
        EXPECT_GE(chosen.size(), fewest);
        EXPECT_LE(chosen.size(), fewest + 2) << "trial " << trial;
    }
}

TEST(PhotoCoverHardCases, NothingSeenInViewOrPreferred) {
    const std::vector<std::uint64_t> none(1, 0), all(1, ~std::uint64_t(0));
    const CoverProblem blind{{{0, 64, 1}}, {{none, none, 1}, {none, none, 1}}};
    EXPECT_TRUE(cover(blind).empty());
    EXPECT_EQ(uncovered_share(blind, {}), 0);
    const CoverProblem no_view{{}, {{all, all, 1}}};
    EXPECT_TRUE(cover(no_view).empty());
    const CoverProblem empty_runs{{{0, 0, 1}, {64, 0, 1}}, {{all, all, 1}}};
    EXPECT_TRUE(cover(empty_runs).empty());
    for (const double preference : {0.0, -1.0, 1e-300, 1e300}) {
        const CoverProblem odd{{{0, 64, 1}}, {{all, all, preference}, {none, none, preference}}};
        EXPECT_EQ(cover(odd), std::vector<std::size_t>{0}) << preference;
    }
    EXPECT_EQ(count_bits(all, 0, 64), 64u);
    EXPECT_EQ(count_bits(all, 63, 1), 1u);
    EXPECT_EQ(count_bits(all, 64, 0), 0u);
}

TEST(FrustumHardCases, KeepsEverySphereThatIntersectsIt) {
    std::mt19937 random(5);
    for (const double fov : {0.1, 45.0, 170.0}) {
        std::size_t kept = 0, all = 0;
        for (int trial = 0; trial < 40; ++trial) {
            const View view = random_view(random, fov);
            std::vector<ClusterRecord> clusters;
            // The spheres are near the line of sight, so that even narrow views contain some of them.
            for (int i = 0; i < 400; ++i) {
                const Eigen::Vector3d on_axis = view.cam_from_origin.center() +
                                                random_in(random, -5, 30) * view.cam_from_origin.direction();
                const double spread = std::pow(10, random_in(random, -4, 1));
                clusters.push_back(sphere(on_axis + spread * random_unit(random),
                                          random() % 4 ? std::pow(10, random_in(random, -5, 0)) : 0));
            }
            const auto found = clusters_in_view(make_cluster_tree(clusters), clusters, view);
            for (std::uint32_t i = 0; i < clusters.size(); ++i, ++all) {
                const long double by = inside_by(view, center(clusters[i])) + clusters[i].radius;
                const bool in = by >= 0, out = by < -1e-4L * (clusters[i].radius + 1e-3L);
                EXPECT_TRUE(!in || holds(found, i)) << "fov " << fov << ", trial " << trial;
                EXPECT_TRUE(!out || !holds(found, i)) << "fov " << fov << ", trial " << trial;
            }
            kept += found.size();
        }
        EXPECT_TRUE(kept > 0 && kept < all);
    }
}

TEST(FrustumHardCases, KeepsSpheresAndPointsThatJustTouchItsPlanes) {
    std::mt19937 random(6);
    for (const double fov : {0.1, 45.0, 170.0})
        for (const double size : {1e-3, 1.0, 1e6})
            for (int trial = 0; trial < 400; ++trial) {
                const Eigen::Vector3d eye = 10 * size * random_unit(random);
                const View view =
                    view_towards(eye, Eigen::Vector3d::Zero(), random_unit(random), fov, 640, 480);
                const Intrinsics& k = view.intrinsics;
                // A point on a side of the frame, and a sphere that touches that side from outside at this
                // point.
                const double x = trial % 2 ? (trial % 4 == 1 ? 0 : k.width) : random_in(random, 0, k.width);
                const double y = trial % 2 ? random_in(random, 0, k.height) : (trial % 4 == 0 ? 0 : k.height);
                const Eigen::Vector3d ray((x - k.cx) / k.fx, (y - k.cy) / k.fy, 1);
                const Eigen::Vector3d side =
                    trial % 2 ? Eigen::Vector3d(x > 0 ? -k.fx : k.fx, 0, x > 0 ? k.width - k.cx : k.cx)
                              : Eigen::Vector3d(0, y > 0 ? -k.fy : k.fy, y > 0 ? k.height - k.cy : k.cy);
                const double radius = trial % 3 == 0 ? 0 : size * random_in(random, 0, 0.5);
                const Eigen::Vector3d at =
                    view.cam_from_origin.R.transpose() * (10 * size * ray - radius * side.normalized()) + eye;
                ClusterRecord c = sphere(at, radius);
                // Enlarge the sphere by the displacement due to rounding to single precision.
                const double by = double(inside_by(view, center(c))) + c.radius;
                if (by < 0) c.radius = std::nextafter(float(c.radius - by), 1e30f);
                const std::vector<ClusterRecord> all(20, c);
                EXPECT_EQ(clusters_in_view(make_cluster_tree(all), all, view).size(), 20u)
                    << "fov " << fov << ", size " << size << ", trial " << trial;
            }
}

TEST(FrustumHardCases, KeepsPointsOnItsPlanes) {
    // The view is axis-aligned, so that its planes contain (x, 0, x) etc. exactly.
    View view = view_towards({0, 0, 0}, {0, 0, 1}, {0, -1, 0}, 90, 2, 2);
    view.intrinsics.fx = view.intrinsics.fy = 1;
    for (const double x : {1e-30, 1.0, 3.0, 1e10})
        for (const Eigen::Vector3d& p :
             {Eigen::Vector3d(x, 0, x), Eigen::Vector3d(-x, 0, x), Eigen::Vector3d(0, x, x),
              Eigen::Vector3d(0, -x, x), Eigen::Vector3d(x, -x, x), Eigen::Vector3d(0, 0, 0)}) {
            const std::vector all{sphere(p, 0)};
            EXPECT_EQ(clusters_in_view(make_cluster_tree(all), all, view).size(), 1u) << p.transpose();
        }
    // The views are randomly rotated, so that the planes' coordinates are rounded.
    std::mt19937 random(7);
    for (int trial = 0; trial < 500; ++trial) {
        const View turned = view_towards(Eigen::Vector3d::Zero(), random_unit(random), random_unit(random),
                                         random_in(random, 1, 170), 640, 480);
        // The camera's center lies on all five planes.
        const std::vector all{sphere(Eigen::Vector3d::Zero(), 0)};
        EXPECT_EQ(clusters_in_view(make_cluster_tree(all), all, turned).size(), 1u) << trial;
        View moved = turned;
        const std::vector there{sphere(random_unit(random), 0)};
        moved.cam_from_origin.t = -moved.cam_from_origin.R * center(there[0]);
        EXPECT_EQ(clusters_in_view(make_cluster_tree(there), there, moved).size(), 1u) << trial;
    }
}

TEST(FrustumHardCases, KeepsTheClustersOfAllVerticesInTheFrame) {
    std::mt19937 random(8);
    for (const double size : {0.01, 1.0, 1e4}) {
        // A crumpled sheet with some degenerate triangles.
        std::vector<Eigen::Vector3f> positions;
        std::vector<std::uint32_t> indices;
        const std::uint32_t n = 40;
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x)
                positions.push_back(
                    (size * Eigen::Vector3d(x / 20.0 - 1, y / 20.0 - 1, random_in(random, -0.05, 0.05)))
                        .cast<float>());
        for (std::uint32_t y = 0; y + 1 < n; ++y)
            for (std::uint32_t x = 0; x + 1 < n; ++x) {
                const std::uint32_t a = y * n + x, b = random() % 10 ? a + 1 : a;
                for (const std::uint32_t i : {a, b, a + n, a + n, b, a + n + 1}) indices.push_back(i);
            }
        const auto clusters = make_clusters(positions, indices, 16);
        const ClusterTree tree = make_cluster_tree(clusters);
        for (const double fov : {0.1, 5.0, 60.0, 170.0})
            for (int trial = 0; trial < 30; ++trial) {
                const Eigen::Vector3d target = positions[random() % positions.size()].cast<double>();
                const View view =
                    view_towards(target + size * std::pow(10, random_in(random, -2, 1)) * random_unit(random),
                                 target, random_unit(random), fov, 640, 480);
                const auto found = clusters_in_view(tree, clusters, view);
                for (std::uint32_t c = 0; c < clusters.size(); ++c) {
                    if (holds(found, c)) continue;
                    for (std::uint32_t t = 3 * clusters[c].first_triangle;
                         t < 3 * (clusters[c].first_triangle + clusters[c].triangles); ++t)
                        ASSERT_LT(double(inside_by(view, positions[indices[t]].cast<double>())), 0)
                            << "size " << size << ", fov " << fov << ", trial " << trial;
                }
                const Eigen::Vector2d range = depth_range(clusters, found, view);
                ASSERT_TRUE(range.allFinite() && range.x() >= 0 && range.y() >= range.x());
                ASSERT_TRUE(range.y() == 0 || range.x() > 0)
                    << "the ratio of the far to the near distance should be finite";
            }
    }
}

TEST(FrustumHardCases, NanSpheresDoNotHideOthers) {
    std::mt19937 random(9);
    for (int trial = 0; trial < 50; ++trial) {
        const View view = random_view(random, 45);
        std::vector<ClusterRecord> clusters;
        for (int i = 0; i < 100; ++i) {
            clusters.push_back(sphere(3 * random_unit(random), 0.1));
            if (random() % 8) continue;
            float* const parts[] = {&clusters.back().center[0], &clusters.back().center[2],
                                    &clusters.back().radius};
            *parts[random() % 3] = float(not_a_number);
        }
        const auto found = clusters_in_view(make_cluster_tree(clusters), clusters, view);
        for (std::uint32_t i = 0; i < clusters.size(); ++i)
            EXPECT_TRUE(!(inside_by(view, center(clusters[i])) + clusters[i].radius >= 0) || holds(found, i))
                << trial;
        EXPECT_TRUE(depth_range(clusters, found, view).allFinite());
    }
}

namespace {

/// Two triangles, each in its own cluster, and one photo that sees both; the second cluster is a single
/// point.
struct TwoClusters {
    std::vector<package::PhotoRecord> photos{1};
    std::vector<ClusterRecord> clusters{sphere({0, 0, 2}, 1), sphere({0, 0, 0}, 0)};
    std::vector<package::CoverageRecord> coverage{{65535, 0, 0, 65535, 65535, 0}, {0, 0, 0, 0, 0, 0}};
    std::vector<std::uint64_t> visible{1, 1};
    std::vector<Eigen::Vector3f> positions{{-1, -1, 2}, {1, -1, 2}, {0, 1, 2}, {0, 0, 0}};
    std::vector<std::uint32_t> indices{0, 1, 2, 3, 3, 3};
    PlanScene scene;

    TwoClusters() {
        photos[0].width = photos[0].height = 64;
        photos[0].levels = 1;
        clusters[0].triangles = clusters[1].triangles = clusters[1].first_triangle = 1;
        clusters[0].cone_cutoff = clusters[1].cone_cutoff = 1;
        scene.photos = photos;
        scene.clusters = clusters;
        scene.tree = make_cluster_tree(clusters);
        scene.intrinsics = {{64, 64, 50, 50, 32, 32}};
        scene.poses = {Pose{}};
        scene.poses[0].R.setIdentity();
        scene.poses[0].t.setZero();
        scene.coverage = {coverage};
        scene.visible = {visible};
        scene.triangles = 2;
        scene.positions = positions;
        scene.indices = indices;
    }
};

}  // namespace

TEST(PlanHardCases, PointClusterAtTheEyeIsPlannedAsUsual) {
    const TwoClusters t;
    const View view = view_towards({0, 0, 0}, {0, 0, 2}, {0, -1, 0}, 60, 64, 64);
    const std::vector<std::uint32_t> photos{0};
    for (const Choice choice : {Choice::cover, Choice::nearest}) {
        PlanSettings s;
        s.choice = choice;
        s.photos = 1;
        const Plan plan = make_plan(t.scene, view, s, photos);
        ASSERT_EQ(plan.photos.size(), 1u) << int(choice);
        EXPECT_GT(plan.photos[0].agreement, 0);
        EXPECT_EQ(plan.uncovered, 0);
    }
    EXPECT_GT(agreements(t.scene, view)[0], 0);
}

TEST(PlanHardCases, IsEmptyIfNothingIsAllowedOrInView) {
    const TwoClusters t;
    const View view = view_towards({0, 0, 0}, {0, 0, 2}, {0, -1, 0}, 60, 64, 64),
               away = view_towards({0, 0, -1}, {0, 0, -5}, {0, -1, 0}, 60, 64, 64);
    EXPECT_TRUE(make_plan(t.scene, view, {}, {}).photos.empty());
    const Plan plan = make_plan(t.scene, away, {}, std::array{0u});
    EXPECT_TRUE(plan.photos.empty() && plan.clusters.empty());
    EXPECT_EQ(plan.uncovered, 0);
    // Triangle indices beyond the model are skipped.
    const Plan odd = make_plan(t.scene, view, {}, std::array{0u}, {.seen = std::array{0u, 3u, ~0u, 1u}});
    EXPECT_EQ(odd.photos.size(), 1u);
}
