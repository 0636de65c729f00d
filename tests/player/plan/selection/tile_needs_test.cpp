#include "player/plan/selection/tile_needs.h"

#include <gtest/gtest.h>

#include <vector>

#include "player/view/view.h"
#include "scene/package/package_reader.h"
#include "tests/player/test_scene.h"

using namespace vantage;

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
        return tile_needs(photo, nullptr, std::vector{seen}, std::vector{ClusterLevels{0, levels}});
    };
    TileNeeds needs = needed(same);
    EXPECT_EQ(needs.color[0], (std::vector<std::uint32_t>{1, 2})) << "columns of 248 px";
    EXPECT_EQ(needs.weight_maps[1], (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(needs.weight_maps[0].empty());
    const View far = view_towards({0, 0, -160}, {0, 0, 0}, {0, -1, 0}, 45, 640, 480);
    needs = needed(far);
    EXPECT_TRUE(needs.color[0].empty());
    EXPECT_EQ(needs.color[photo.levels - 1].size(), 1u);
    seen.seen = 0;
    EXPECT_EQ(needed(same).tiles(), 0u);
}
