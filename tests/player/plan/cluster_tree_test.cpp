#include "player/plan/cluster_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/player/test_scene.h"

using namespace vantage;

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
                EXPECT_TRUE(std::ranges::binary_search(in_view, c)) << "a visible cluster was culled";
            }
        }
    }
    EXPECT_LT(found, 100u * 500) << "clusters out of view are culled";
    EXPECT_TRUE(clusters_in_view(make_cluster_tree({}), {}, random_view(random)).empty());
}

TEST(ClusterTree, DropsClustersBehindTheViewer) {
    const std::vector clusters{cluster_at({0, 0, 5}, 1)};
    const View away = view_towards({0, 0, 0}, {0, 0, -1}, {0, -1, 0}, 45, 640, 480);
    EXPECT_TRUE(clusters_in_view(make_cluster_tree(clusters), clusters, away).empty());
    EXPECT_EQ(depth_range(clusters, {}, away), Eigen::Vector2d(0, 0));
}
