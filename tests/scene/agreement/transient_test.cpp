#include <gtest/gtest.h>

#include <numeric>
#include <opencv2/imgproc.hpp>
#include <random>

#include "pipeline/stages/cut_tile.h"
#include "scene/agreement/transient_map.h"
#include "scene/agreement/transient_partners.h"
#include "scene/agreement/transient_weights.h"

using namespace vantage;

TEST(TransientMap, NoiseIsRemovedAsByOpenCv) {
    std::mt19937 random(3);
    for (const auto& [width, height] :
         {std::pair{40, 31}, std::pair{2, 3}, std::pair{1, 1}, std::pair{1, 7}, std::pair{9, 2}}) {
        std::vector<std::uint8_t> weight(std::size_t(width) * std::size_t(height), 255);
        for (std::uint8_t& w : weight)
            if (random() % 2) w = std::uint8_t(random());
        cv::Mat expected;
        cv::medianBlur(cv::Mat(height, width, CV_8U, weight.data()), expected, 3);
        cv::erode(expected, expected, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
        cv::GaussianBlur(expected, expected, {3, 3}, 0);
        const std::vector<std::uint8_t> wanted(expected.begin<std::uint8_t>(), expected.end<std::uint8_t>());
        EXPECT_EQ(without_noise(weight, width, height), wanted) << width << 'x' << height;
    }
}

TEST(TransientWeights, TilesGetTheWeightsOfTheirLevel) {
    std::mt19937 random(5);
    TransientMap map{90, 70, std::vector<std::uint8_t>(90 * 70), 0};
    for (std::uint8_t& w : map.weight) w = std::uint8_t(random());
    const Level level{301, 255};
    std::vector<std::byte> before(4 * 301 * 255);
    for (std::byte& b : before) b = std::byte(random() % 3);  // a third of the texels do not show the model
    std::vector<std::byte> whole = before, tile(tile_bytes), wanted(tile_bytes);
    set_weights(&map, level, {whole.data(), 4 * level.width, level.height}, 0, 0);
    for (std::size_t t = 0; t < std::size_t(level.tiles()); ++t) {
        cut_tile(before, level, t, tile);
        set_tile_weights(&map, level, t, tile);
        cut_tile(whole, level, t, wanted);
        EXPECT_EQ(tile, wanted) << t;
    }
    set_weights(nullptr, level, {whole.data(), 4 * level.width, level.height}, 0, 0);
    for (std::size_t i = 3; i < whole.size(); i += 4)
        ASSERT_EQ(whole[i], before[i] == std::byte(0) ? std::byte(0) : std::byte(255));
}

TEST(TransientPartners, WithoutAPhotoAreThoseOfTheSceneWithoutIt) {
    // There are more photos than the maximum number of partners, and some of them are tied in the number of
    // discs that they share.
    constexpr std::size_t photos = 36, discs = 600;
    std::mt19937 random(7);
    std::vector<package::PhotoRecord> records(photos, package::PhotoRecord{});
    std::vector<std::vector<package::SampleRecord>> samples(photos);
    for (std::size_t i = 0; i < photos; ++i) {
        for (std::size_t d = 0; d < 3; ++d) records[i].R[4 * d] = 1;
        records[i].t[0] = 0.05 * double(i);
        records[i].t[2] = 3;
        for (std::size_t d = 0; d < discs; ++d)
            samples[i].push_back(random() % 5 < 3 || d < 40 ? package::SampleRecord{{900, 900, 900}, 0}
                                                            : package::SampleRecord{});
    }
    std::vector<SurfaceDisc> surface(discs);
    for (SurfaceDisc& d : surface) d.center = {float(random() % 100) / 50, float(random() % 100) / 50, 0};
    const auto partners = [&] {
        const std::vector<std::span<const package::SampleRecord>> spans(samples.begin(), samples.end());
        return TransientPartners(SharedSurface(records, spans, surface));
    };
    const TransientPartners all = partners();
    std::size_t changed = 0;
    for (std::uint32_t without = 0; without < photos; ++without) {
        const auto kept = std::exchange(samples[without], {});
        const TransientPartners rest = partners();
        for (std::uint32_t i = 0; i < photos; ++i) {
            if (i == without) continue;
            EXPECT_EQ(all.of(i, without), rest.of(i)) << i << " without " << without;
            changed += all.of(i) != rest.of(i);
        }
        samples[without] = kept;
    }
    EXPECT_GT(changed, photos);
}
