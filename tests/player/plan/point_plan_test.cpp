#include "player/plan/point_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "pipeline/mesh/point_tree.h"
#include "tests/player/test_scene.h"

using namespace vantage;

namespace {

/// Two sheets of points and their octree.
struct TestCloud {
    Mesh points;
    PointTree tree;
    PointCloud cloud;

    explicit TestCloud(std::size_t count) {
        Random random;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = random(-2, 2), y = random(-2, 2);
            points.positions.emplace_back(x, y, i % 2 ? 0.3 * std::sin(4 * x) : 1 + 0.2 * y);
        }
        tree = make_point_tree(points, Eigen::Vector3d::Zero());
        cloud.nodes = tree.nodes;
        cloud.blocks = tree.blocks;
        cloud.points = count;
    }
    const Eigen::Vector3d& position(std::uint32_t node, std::uint32_t i) const {
        return points.positions[tree.order[tree.starts[node] + i]];
    }
};

constexpr std::uint64_t all = 1'000'000'000;

bool is_shown(const View& view, const Eigen::Vector3d& p) {
    const auto at = project(view.intrinsics, view.cam_from_origin, p);
    return at && at->pixel.x() >= 0 && at->pixel.y() >= 0 && at->pixel.x() < view.intrinsics.width &&
           at->pixel.y() < view.intrinsics.height;
}

}  // namespace

TEST(PointPlan, NeverCullsAVisiblePoint) {
    const TestCloud test(150'000);
    Random random;
    std::size_t planned = 0, culled = 0;
    for (int trial = 0; trial < 300; ++trial) {
        // Views in every direction, some of them from positions among the points.
        const View view =
            view_towards(random.vector(3), random.vector(3), random.vector(1), random(10, 100), 640, 480);
        const PointPlan with = plan_points(test.cloud, view, all, 1);
        const std::set<std::uint32_t> kept(with.nodes.begin(), with.nodes.end());
        for (const std::uint32_t node : plan_points(test.cloud, view, all, 1, PointCulling::none).nodes) {
            ++planned;
            if (kept.contains(node)) continue;
            ++culled;
            for (std::uint32_t i = 0; i < test.cloud.nodes[node].count; ++i)
                ASSERT_FALSE(is_shown(view, test.position(node, i))) << "a visible point was culled";
        }
    }
    EXPECT_GT(culled, planned / 4) << "points out of view are culled";
}

TEST(PointPlan, TakesTheNearestAndCoarsestWithinTheBudget) {
    const TestCloud test(200'000);
    const View view = view_towards({0, -4, 2}, {0, 0, 0}, {0, 0, 1}, 60, 1280, 720);
    const PointPlan whole = plan_points(test.cloud, view, all, 1);
    EXPECT_TRUE(whole.whole);
    for (const std::uint64_t budget : {1ull, 20'000ull, 80'000ull}) {
        const PointPlan plan = plan_points(test.cloud, view, budget, 1);
        EXPECT_FALSE(plan.whole);
        EXPECT_LE(plan.points, std::max<std::uint64_t>(budget, test.cloud.nodes[0].count));
        ASSERT_FALSE(plan.nodes.empty());
        EXPECT_EQ(plan.nodes.front(), 0u);
        // The plan is a prefix of the whole plan: a larger budget only adds nodes.
        EXPECT_TRUE(std::equal(plan.nodes.begin(), plan.nodes.end(), whole.nodes.begin()));
    }
    const View far = view_towards({0, -4000, 2}, {0, 0, 0}, {0, 0, 1}, 60, 1280, 720);
    EXPECT_EQ(plan_points(test.cloud, far, all, 1).nodes.size(), 1u) << "finer nodes would be invisible";
    const View away = view_towards({0, -4, 2}, {0, -8, 2}, {0, 0, 1}, 60, 1280, 720);
    EXPECT_TRUE(plan_points(test.cloud, away, all, 1).nodes.empty());
    EXPECT_EQ(depth_range(test.cloud, plan_points(test.cloud, away, all, 1), away, 1e9),
              Eigen::Vector2d(0, 0));
}

TEST(PointPlan, DrawsOnlyWhatIsResidentBelowWhatIsDrawn) {
    const TestCloud test(200'000);
    const View view = view_towards({0, -4, 2}, {0, 0, 0}, {0, 0, 1}, 60, 1280, 720);
    const PointPlan plan = plan_points(test.cloud, view, all, 1);
    ASSERT_GT(plan.nodes.size(), 20u);
    const auto count = [&](const std::function<bool(std::uint32_t)>& resident) {
        const std::vector<DrawnNode> drawn = drawn_nodes(test.cloud, plan, resident);
        std::set<std::uint32_t> once;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            EXPECT_TRUE(resident(drawn[i].node));
            EXPECT_TRUE(once.insert(drawn[i].node).second);
            // Children are stored where the shader expects them, in the order of their octants.
            const package::PointNode& n = test.cloud.nodes[drawn[i].node];
            std::uint32_t child = n.children, at = drawn[i].first;
            for (unsigned octant = 0; octant < 8; ++octant) {
                if (!(n.child_octants >> octant & 1)) continue;
                if (drawn[i].children >> octant & 1) {
                    EXPECT_EQ(drawn.at(at++).node, child);
                }
                ++child;
            }
        }
        return drawn.size();
    };
    EXPECT_EQ(count([](std::uint32_t) { return true; }), plan.nodes.size());
    EXPECT_EQ(count([](std::uint32_t node) { return node != 0; }), 0u);
    EXPECT_EQ(count([](std::uint32_t node) { return node == 0 || node > 8; }), 1u);
}
