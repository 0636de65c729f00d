#include "player/plan/normal_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/player/test_scene.h"

using namespace vantage;

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
    ASSERT_EQ(cluster_normals(same, 4, 5).size(), 1u) << "fewer than requested";
    EXPECT_EQ(cluster_normals(same, 4, 5)[0].members, 7u);
    EXPECT_TRUE(cluster_normals(same, 0, 5).empty());
    for (const NormalCluster& c : cluster_normals(opposite, 1, 5)) EXPECT_NEAR(c.direction.norm(), 1, 1e-12);
    ASSERT_EQ(cluster_normals(broken, 2, 5).size(), 1u);
}
