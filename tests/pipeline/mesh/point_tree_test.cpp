#include "pipeline/mesh/point_tree.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "scene/package/contents/point_cloud.h"

using namespace vantage;
using package::PointNode;

namespace {

Mesh random_cloud(std::size_t points, double size, const Eigen::Vector3d& at) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(-0.5, 0.5);
    Mesh cloud;
    for (std::size_t i = 0; i < points; ++i) {
        // The surface is wavy, so that cells are occupied as in a scan.
        const double x = share(random), y = share(random), z = 0.2 * std::sin(9 * x) * std::cos(7 * y);
        cloud.positions.push_back(at + size * Eigen::Vector3d(x, y, z));
    }
    return cloud;
}

Eigen::AlignedBox3d cube_of(const PointNode& n) {
    const Eigen::Vector3d low(n.low[0], n.low[1], n.low[2]);
    return {low, low + Eigen::Vector3d::Constant(double(n.size))};
}

/// Checks the invariants of every tree. Each point is in exactly one node and within that node's cube, and
/// its stored position is within the guaranteed error. Nodes lie within their parents and within the blocks.
void expect_valid(const PointTree& tree, const Mesh& cloud, const Eigen::Vector3d& origin) {
    std::vector<int> times(cloud.positions.size(), 0);
    std::uint32_t next = 1;
    std::map<std::uint32_t, std::uint32_t> used;
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        const PointNode& node = tree.nodes[n];
        EXPECT_LE(node.count, package::point_node);
        EXPECT_EQ(node.first, used[node.block]) << "blocks are filled without gaps";
        used[node.block] += node.count;
        EXPECT_GT(node.spacing, 0);
        const double reach = cube_of(node).center().cwiseAbs().maxCoeff() + double(node.size);
        const double rounding = 1e-6 * reach;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const std::uint32_t point = tree.order[tree.starts[n] + i];
            ++times[point];
            const Eigen::Vector3d p = cloud.positions[point] - origin;
            EXPECT_LE(cube_of(node).exteriorDistance(p), rounding);
            EXPECT_LE((unpacked(packed(p, node), node) - p).cwiseAbs().maxCoeff(),
                      double(node.size) * 0x1p-22 + rounding);
        }
        if (node.child_octants) {
            EXPECT_EQ(node.children, next);
        }
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (!(node.child_octants >> octant & 1)) continue;
            const PointNode& child = tree.nodes.at(next++);
            Eigen::Vector3d middle = cube_of(node).min();
            for (int axis = 0; axis < 3; ++axis)
                middle[axis] += double(node.size) * (octant >> axis & 1 ? 0.75 : 0.25);
            if (child.size < node.size) {
                EXPECT_LE((cube_of(child).center() - middle).norm(), rounding + 1e-6 * double(node.size));
            }
        }
    }
    EXPECT_EQ(next, std::max<std::size_t>(1, tree.nodes.size()));
    for (const auto& [block, points] : used) EXPECT_LE(points, package::point_block);
    EXPECT_EQ(used.size(), tree.blocks);
    EXPECT_TRUE(std::ranges::all_of(times, [](int t) { return t == 1; })) << "each point once";
}

}  // namespace

TEST(PointTree, HoldsEachPointOnceNearWhereItIs) {
    for (const auto& [points, size, at] :
         {std::tuple(std::size_t(1), 1.0, Eigen::Vector3d(0, 0, 0)),
          std::tuple(std::size_t(300), 1.0, Eigen::Vector3d(5, 5, 5)),
          std::tuple(std::size_t(200'000), 40.0, Eigen::Vector3d(0, 0, 0)),
          std::tuple(std::size_t(50'000), 1e-3, Eigen::Vector3d(0, 0, 0)),
          std::tuple(std::size_t(50'000), 100.0, Eigen::Vector3d(481234, 5412345, 312))}) {
        const Mesh cloud = random_cloud(points, size, at);
        expect_valid(make_point_tree(cloud, at), cloud, at);
    }
}

TEST(PointTree, SurvivesPointsInOnePlaceAndStrays) {
    Mesh cloud = random_cloud(40'000, 1, Eigen::Vector3d::Zero());
    cloud.positions.resize(90'000, Eigen::Vector3d(0.1, 0.1, 0.1));  // 50,000 at one position
    expect_valid(make_point_tree(cloud, Eigen::Vector3d::Zero()), cloud, Eigen::Vector3d::Zero());
    cloud.positions.emplace_back(1e9, 0, 0);
    expect_valid(make_point_tree(cloud, Eigen::Vector3d::Zero()), cloud, Eigen::Vector3d::Zero());
    Mesh same;
    same.positions.resize(100'000, Eigen::Vector3d(7, 7, 7));
    const PointTree tree = make_point_tree(same, Eigen::Vector3d(7, 7, 7));
    expect_valid(tree, same, Eigen::Vector3d(7, 7, 7));
    EXPECT_TRUE(make_point_tree({}, Eigen::Vector3d::Zero()).empty());
}

TEST(PointTree, CoarseNodesSpreadTheirPointsEvenly) {
    const Mesh cloud = random_cloud(300'000, 10, Eigen::Vector3d::Zero());
    const PointTree tree = make_point_tree(cloud, Eigen::Vector3d::Zero());
    const PointNode& root = tree.nodes.front();
    ASSERT_GT(tree.nodes.size(), 10u);
    ASSERT_NE(root.child_octants, 0);
    // The root has at most one point per cell, and it has a point near every point of the cloud.
    std::set<std::array<int, 3>> cells;
    for (std::uint32_t i = 0; i < root.count; ++i) {
        const Eigen::Vector3d p =
            (cloud.positions[tree.order[tree.starts[0] + i]] - cube_of(root).min()) / double(root.spacing);
        EXPECT_TRUE(cells.insert({int(p.x()), int(p.y()), int(p.z())}).second);
    }
    for (std::size_t i = 0; i < cloud.positions.size(); i += 997) {
        double nearest = 1e9;
        for (std::uint32_t n = 0; n < root.count; ++n)
            nearest = std::min(nearest,
                               (cloud.positions[i] - cloud.positions[tree.order[tree.starts[0] + n]]).norm());
        EXPECT_LE(nearest, 1.74 * double(root.spacing));
    }
}
