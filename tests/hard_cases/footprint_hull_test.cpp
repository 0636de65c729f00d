// Compares the footprint hull of a photo with an independent computation.
#include "pipeline/stages/coordinates/footprint_hull.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

using namespace vantage;

namespace {

/// The corners of the convex hull in order, computed in double precision (Andrew's monotone chain).
std::vector<Eigen::Vector2d> hull_of(std::vector<Eigen::Vector2d> p) {
    std::ranges::sort(
        p, [](const auto& a, const auto& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    p.erase(std::unique(p.begin(), p.end()), p.end());
    if (p.size() < 3) return p;
    std::vector<Eigen::Vector2d> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = hull.size();
        for (const Eigen::Vector2d& q : p) {
            const auto turns_left = [&] {
                const Eigen::Vector2d u = hull.back() - hull[hull.size() - 2], v = q - hull.back();
                return u.x() * v.y() - u.y() * v.x() > 0;
            };
            while (hull.size() >= start + 2 && !turns_left()) hull.pop_back();
            hull.push_back(q);
        }
        hull.pop_back();
        std::ranges::reverse(p);
    }
    return hull;
}

struct Polygon {
    double area = 0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
};
Polygon measured(const std::vector<Eigen::Vector2d>& corners) {
    Polygon out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d a = corners[i] - corners[0], b = corners[(i + 1) % corners.size()] - corners[0];
        const double part = (a.x() * b.y() - a.y() * b.x()) / 2;
        out.area += part;
        out.centroid += part * (a + b) / 3;
    }
    if (out.area > 0) out.centroid = corners[0] + out.centroid / out.area;
    return out;
}

const Intrinsics frame{400, 300, 350, 360, 190, 160};

Eigen::Vector3d through(const Eigen::Vector2d& uv) {
    return Eigen::Vector3d((uv.x() * frame.width - frame.cx) / frame.fx,
                           (uv.y() * frame.height - frame.cy) / frame.fy, 1)
        .normalized();
}

}  // namespace

TEST(FootprintHull, MatchesTheMonotoneChain) {
    std::mt19937 random(19);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Eigen::Vector2f> uv;
        std::vector<Eigen::Vector2d> visible;
        const int points = 3 + trial % 40, grid = trial % 3 ? 0 : 5;
        for (int i = 0; i < points; ++i) {
            Eigen::Vector2d p(unit(random), unit(random) * (trial % 7 ? 1 : 0.01));
            if (grid) p = (p * grid).array().floor() / grid;  // many are collinear or equal
            const Eigen::Vector2f q = p.cast<float>();
            uv.push_back(q);
            visible.push_back(q.cast<double>());
            if (i % 4 == 0) uv.emplace_back(-1, -1);
        }
        const Polygon truth = measured(hull_of(visible));
        const FootprintHull found = footprint_hull(uv, frame, Pose{});
        ASSERT_NEAR(found.area, truth.area, 1e-6) << "trial " << trial;
        ASSERT_TRUE(truth.area < 1e-5 || (found.direction - through(truth.centroid)).norm() < 1e-3)
            << "trial " << trial;
        ASSERT_NEAR(found.direction.norm(), 1, 1e-9);
    }
}

RC_GTEST_PROP(FootprintHull, AnyPointsMatchTheMonotoneChain, ()) {
    // The points are on a coarse grid, so that many of them are collinear or equal.
    const auto grid = *rc::gen::container<std::vector<std::array<int, 2>>>(
        rc::gen::container<std::array<int, 2>>(rc::gen::inRange(0, 17)));
    std::vector<Eigen::Vector2f> uv;
    std::vector<Eigen::Vector2d> visible;
    for (const auto& [x, y] : grid) {
        uv.emplace_back(float(x) / 16, float(y) / 16);
        visible.push_back(uv.back().cast<double>());
    }
    const Polygon truth = visible.empty() ? Polygon{} : measured(hull_of(visible));
    const FootprintHull found = footprint_hull(uv, frame, Pose{});
    RC_ASSERT(std::abs(found.area - truth.area) < 1e-6);
    RC_ASSERT(std::abs(found.direction.norm() - 1) < 1e-9);
    if (truth.area > 1e-5) RC_ASSERT((found.direction - through(truth.centroid)).norm() < 1e-3);
}

TEST(FootprintHull, NoPointsOnePointOrALineHaveNoAreaButADirection) {
    const Pose pose{Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                    {1, 2, 3}};
    for (const auto& uv : {std::vector<Eigen::Vector2f>{}, std::vector<Eigen::Vector2f>(50, {-1, -1})}) {
        const FootprintHull none = footprint_hull(uv, frame, pose);
        EXPECT_EQ(none.area, 0);
        EXPECT_LT((none.direction - pose.direction()).norm(), 1e-12) << "the optical axis";
    }
    const Eigen::Vector2f a(0.2f, 0.3f);
    for (const std::size_t copies : {1u, 2u, 3u, 1000u}) {
        const FootprintHull point = footprint_hull(std::vector<Eigen::Vector2f>(copies, a), frame, Pose{});
        EXPECT_EQ(point.area, 0) << copies;
        EXPECT_LT((point.direction - through(a.cast<double>())).norm(), 1e-6) << copies;
    }
    for (const Eigen::Vector2f& along :
         {Eigen::Vector2f(0.5f, 0), {0, 0.5f}, {0.5f, 0.25f}, {0.375f, 0.5f}}) {
        std::vector<Eigen::Vector2f> line;
        for (int i = 0; i <= 16; ++i)
            line.push_back(Eigen::Vector2f(0.25f, 0.25f) + float(i * i % 17) / 16 * along);
        line.push_back(Eigen::Vector2f(0.25f, 0.25f) + along);
        const FootprintHull found = footprint_hull(line, frame, Pose{});
        EXPECT_NEAR(found.area, 0, 1e-9) << along.transpose();
        const Eigen::Vector3d from = through({0.25, 0.25}),
                              to = through((Eigen::Vector2f(0.25f, 0.25f) + along).cast<double>());
        EXPECT_LT(std::abs(found.direction.dot(from.cross(to).normalized())), 1e-6) << "on the line";
        EXPECT_GE(found.direction.dot(from), to.dot(from) - 1e-6) << "between its ends";
    }
}
