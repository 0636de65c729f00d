#include "player/plan/selection/shown_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "player/view/view.h"
#include "scene/package/package_reader.h"
#include "tests/player/test_scene.h"

using namespace vantage;

namespace {

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

}  // namespace

TEST(ShownTiles, ContainTilesWithEnoughVisiblePixels) {
    const package::PhotoRecord photo = photo_at({0, 0, -10}, Eigen::Matrix3d::Identity());
    const auto needs = [&](const std::vector<SurfaceSample>& samples, double pixels) {
        const std::vector<float> weights(samples.size(), 1.0f);
        return shown_tiles(photo, nullptr, cam_from_origin(photo), {samples, weights, pixels}, 0.1);
    };
    // From the photo's own camera, each pixel is a texel. The first 268 columns fill tile 0 and 20 columns of
    // tile 1.
    const View own = view_of_photo(photo, 1);
    TileNeeds n = needs(plane_samples(own, 4, 0, 268), 16);
    EXPECT_EQ(n.color[0], (std::vector<std::uint32_t>{0, 7, 14, 21, 28, 35})) << "seven columns, six rows";
    EXPECT_TRUE(n.color[1].empty() || n.color[1].front() == 0) << "the next coarser level covers tile 1";
    n = needs(plane_samples(own, 4, 0, 280), 16);
    EXPECT_EQ(n.color[0].size(), 11u)
        << "32 of 248 columns are more than a tenth of a tile, except in the partial last row";
    // At four times the distance, colors and weight maps are two levels coarser.
    const View far = view_of_photo(photo_at({0, 0, -40}, Eigen::Matrix3d::Identity()), 1);
    n = needs(plane_samples(far, 4, 0, 1700), 16);
    EXPECT_TRUE(n.color[0].empty() && n.color[1].empty() && n.weight_maps[1].empty());
    EXPECT_EQ(n.color[2].size(), 4u) << "425 x 325 texels";
    EXPECT_EQ(n.weight_maps[2].size(), 4u);
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
        const std::vector<float> weights(samples.size(), 1.0f);
        const TileNeeds n =
            shown_tiles(photo, nullptr, cam_from_origin(photo), {samples, weights, 50}, random(0, 1));
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
            EXPECT_TRUE(finds(n.color) && finds(n.weight_maps));
        }
    }
}
