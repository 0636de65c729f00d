#include "pipeline/stages/masks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "gl/context.h"
#include "pipeline/pixels/pyramid.h"
#include "pipeline/settings/settings.h"
#include "pipeline/stages/borders.h"
#include "pipeline/stages/depth_summary.h"
#include "pipeline/stages/seen_hull.h"
#include "pipeline/visibility/border_distance.h"
#include "pipeline/visibility/near_distance.h"

using namespace vantage;

namespace {

std::vector<std::uint8_t> scattered(int width, int height, int every) {
    std::mt19937 random(7);
    std::vector<std::uint8_t> borders(std::size_t(width) * std::size_t(height), 0);
    for (std::size_t i = 0; i < borders.size() / std::size_t(every); ++i)
        borders[random() % borders.size()] = 1;
    return borders;
}

std::vector<float> brute_force(const std::vector<std::uint8_t>& borders, int width, int height) {
    std::vector<float> d(borders.size(), std::numeric_limits<float>::infinity());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int v = 0; v < height; ++v)
                for (int u = 0; u < width; ++u)
                    if (borders[std::size_t(v * width + u)]) {
                        float& at = d[std::size_t(y * width + x)];
                        at = std::min(at, std::hypot(float(u - x), float(v - y)));
                    }
    return d;
}

}  // namespace

TEST(BorderDistance, ExactMatchesBruteForce) {
    const auto borders = scattered(61, 47, 150);
    const auto exact = exact_distance(borders, 61, 47), truth = brute_force(borders, 61, 47);
    for (std::size_t i = 0; i < truth.size(); ++i) ASSERT_NEAR(exact[i], truth[i], 1e-3) << i;
}

TEST(BorderDistance, NearMatchesBruteForceWithinItsReach) {
    for (const auto& [width, height] : {std::pair(61, 47), {1, 90}, {90, 1}, {1, 1}, {33, 3}})
        for (const int reach : {0, 1, 7, farthest_near}) {
            const auto borders = scattered(width, height, 30);
            const auto near = near_distance(borders, width, height, reach);
            const auto truth = brute_force(borders, width, height);
            for (std::size_t i = 0; i < truth.size(); ++i)
                if (truth[i] <= float(reach))
                    ASSERT_NEAR(near[i], truth[i], 1e-4)
                        << width << "x" << height << " " << reach << " " << i;
                else
                    ASSERT_TRUE(std::isinf(near[i])) << width << "x" << height << " " << reach << " " << i;
        }
}

TEST(BorderDistance, JumpFloodingNeverUnderestimatesAndIsRarelyWrong) {
    const gl::HeadlessContext context(gl::Debug::on);
    const gl::Program jump_flood = jump_flood_program();
    const auto borders = scattered(203, 119, 400);
    const auto exact = exact_distance(borders, 203, 119);
    for (const auto m : {DistanceMethod::jfa, DistanceMethod::jfa_plus_1, DistanceMethod::one_plus_jfa,
                         DistanceMethod::jfa_squared}) {
        const auto flooded = flood_distance(jump_flood, borders, 203, 119, m);
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            ASSERT_GE(flooded[i], exact[i] - 1e-3f) << name(m);
            wrong += flooded[i] > exact[i] + 1e-3f;
        }
        EXPECT_LT(double(wrong) / double(exact.size()), 0.01) << name(m);
    }
}

TEST(BorderDistance, NoBorderAndOnlyBorderAreDefined) {
    const gl::HeadlessContext context(gl::Debug::on);
    const gl::Program jump_flood = jump_flood_program();
    const std::vector<std::uint8_t> none(64, 0), all(64, 1);
    for (const float d : exact_distance(none, 8, 8)) EXPECT_TRUE(std::isinf(d));
    for (const float d : flood_distance(jump_flood, none, 8, 8, DistanceMethod::jfa))
        EXPECT_TRUE(std::isinf(d));
    for (const float d : exact_distance(all, 8, 8)) EXPECT_EQ(d, 0);
    for (const float d : flood_distance(jump_flood, all, 8, 8, DistanceMethod::jfa)) EXPECT_EQ(d, 0);
    const auto mask = border_mask(exact_distance(none, 8, 8), 8, 8, 2);
    EXPECT_EQ(mask[0], std::lround(255 * 0.25));  // half a pixel from the outline
    EXPECT_EQ(mask[3 * 8 + 3], 255);
}

TEST(BorderDistance, MaskIsZeroOnABorderAndBesideIt) {
    std::vector<std::uint8_t> borders(64 * 64, 0);
    for (std::size_t y = 0; y < 64; ++y) borders[y * 64 + 20] = 1;
    const auto mask = border_mask(exact_distance(borders, 64, 64), 64, 64, 8);
    const auto at = [&](std::size_t x) { return int(mask[32 * 64 + x]); };
    EXPECT_EQ(at(20), 0);
    EXPECT_EQ(at(21), 0);
    EXPECT_EQ(at(22), 32);
    EXPECT_EQ(at(29), 255);
}

TEST(Borders, SlantedPlaneHasNoneAndStepHasOne) {
    DepthMap plane{40, 30, std::vector<float>(1200), {}}, step = plane;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            plane.z[std::size_t(y * 40 + x)] = 1 / (1.0f - 0.02f * float(x));  // a plane seen at a slant
            step.z[std::size_t(y * 40 + x)] = x < 20 ? 5.0f : 6.0f;
        }
    for (const std::uint8_t b : find_borders(plane, 0.01f)) ASSERT_EQ(b, 0);
    const auto found = find_borders(step, 0.01f);
    EXPECT_TRUE(found[15 * 40 + 19] && found[15 * 40 + 20]);
    EXPECT_FALSE(found[15 * 40 + 17] || found[15 * 40 + 22]);
}

TEST(Pyramid, TilesHoldEveryTexelAndItsNeighbors) {
    const Level level{600, 300};
    std::vector<std::uint32_t> texels(std::size_t(level.width) * std::size_t(level.height));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = std::uint32_t(i);
    std::vector<std::uint32_t> stored(tile_bytes / 4);
    for (int t = 0; t < level.tiles(); ++t) {
        cut_tile(std::as_bytes(std::span(texels)), level, std::size_t(t),
                 std::as_writable_bytes(std::span(stored)));
        for (int y = 0; y < tile_size; ++y)
            for (int x = 0; x < tile_size; ++x) {
                const int u =
                    std::clamp(t % level.columns() * tile_content + x - tile_border, 0, level.width - 1);
                const int v =
                    std::clamp(t / level.columns() * tile_content + y - tile_border, 0, level.height - 1);
                ASSERT_EQ(stored[std::size_t(y) * tile_size + std::size_t(x)],
                          std::uint32_t(v * level.width + u));
            }
    }
}

TEST(Pyramid, HalvingAveragesLinearLightAndRepeatsOddEdges) {
    const RgbaImage image{3, 1, {0, 0, 0, 255, 255, 255, 255, 255, 90, 90, 90, 255}};
    const RgbaImage half = halve(image);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_NEAR(half.rgba[0], 188, 1);  // half the light of white, in sRGB
    EXPECT_NEAR(half.rgba[4], 90, 1);
}

TEST(Pyramid, TransparentTexelsContributeNoColor) {
    const RgbaImage half = halve(RgbaImage{2, 1, {200, 100, 50, 255, 0, 0, 0, 0}});
    EXPECT_NEAR(half.rgba[0], 200, 1);
    EXPECT_NEAR(half.rgba[1], 100, 1);
    EXPECT_EQ(half.rgba[3], 128);
}

TEST(SeenHull, DegenerateSetsHaveADirection) {
    const Intrinsics k{100, 80, 90, 90, 50, 40};
    const Pose pose;
    const auto nothing = seen_hull({{-1, -1}}, k, pose);
    EXPECT_EQ(nothing.area, 0);
    EXPECT_TRUE(nothing.direction.isApprox(Eigen::Vector3d::UnitZ()));
    const auto line = seen_hull({{0.25f, 0.5f}, {0.5f, 0.5f}, {0.75f, 0.5f}}, k, pose);
    EXPECT_EQ(line.area, 0);
    EXPECT_TRUE(line.direction.isApprox(Eigen::Vector3d::UnitZ(), 1e-6));
    const auto square = seen_hull({{0, 0}, {1, 0}, {1, 0.5f}, {0, 0.5f}, {0.5f, 0.25f}}, k, pose);
    EXPECT_NEAR(square.area, 0.5, 1e-6);
    EXPECT_NEAR(square.direction.y() / square.direction.z(), (0.25 * 80 - 40) / 90, 1e-5);
}

TEST(MaskPyramid, AveragesOnlyValidTexels) {
    const float inf = std::numeric_limits<float>::infinity();
    // 3x2: one valid block with a hole in it, and an odd column where nothing is seen.
    MaskLevel fine{3, 2, std::vector<std::uint8_t>(24, 0), {1, 5, inf, 3, inf, inf}};
    const std::uint8_t angle[] = {10, 20, 0, 33, 0, 0};
    for (std::size_t i = 0; i < 6; ++i) {
        fine.masks[4 * i] = angle[i];
        fine.masks[4 * i + 3] = std::isfinite(fine.z[i]) ? 255 : 0;
    }
    const MaskLevel coarse = halve(fine);
    ASSERT_EQ(coarse.width, 2);
    ASSERT_EQ(coarse.height, 1);
    EXPECT_EQ(coarse.z[0], 5) << "what the farthest texel sees stays seen";
    EXPECT_EQ(int(coarse.masks[0]), 21) << "mean of the three valid ones";
    EXPECT_EQ(int(coarse.masks[3]), 255);
    EXPECT_EQ(coarse.z[1], inf);
    EXPECT_EQ(int(coarse.masks[7]), 0);
}

TEST(Masks, DepthHasTwelveStepsPerOctave) {
    std::vector<float> z;
    for (double exponent = -20; exponent < 20; exponent += 0.0173) z.push_back(float(std::exp2(exponent)));
    z.push_back(std::numeric_limits<float>::infinity());
    const std::vector<std::uint8_t> angle(z.size(), 77), border(z.size(), 5);
    const double focal = 2000, reference = 3000;
    const auto masks = combine_masks(z, angle, border, focal, reference);
    for (std::size_t i = 0; i + 1 < z.size(); ++i) {
        const double code = std::clamp(255 + 12 * std::log2(focal / z[i] / reference), 1.0, 255.0);
        ASSERT_NEAR(masks[4 * i + 1], code, 0.501) << z[i];
        ASSERT_EQ(masks[4 * i], 77);
        ASSERT_EQ(masks[4 * i + 2], 5);
        ASSERT_EQ(masks[4 * i + 3], 255);
    }
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(masks[masks.size() - 4 + c], 0) << "nothing is seen there";
}

TEST(DepthSummary, IgnoresInfiniteDepths) {
    std::mt19937 random(3);
    std::lognormal_distribution<float> depth(1, 0.7f);
    for (const std::size_t count : {1u, 2u, 17u, 5000u, 100000u}) {
        std::vector<float> z(count), finite;
        for (float& v : z) v = random() % 3 ? depth(random) : std::numeric_limits<float>::infinity();
        z[count / 2] = 2;
        for (const float v : z)
            if (std::isfinite(v)) finite.push_back(v);
        std::ranges::sort(finite);
        const auto found = summarize_depths(z);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->nearest, finite.front());
        EXPECT_EQ(found->farthest, finite.back());
        EXPECT_GE(found->median, finite[finite.size() * 45 / 100]);
        EXPECT_LE(found->median, finite[finite.size() * 55 / 100]);
    }
    EXPECT_FALSE(summarize_depths(std::vector<float>(9, std::numeric_limits<float>::infinity())));
    EXPECT_FALSE(summarize_depths({}));
}
