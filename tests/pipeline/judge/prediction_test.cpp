#include "pipeline/judge/prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace vantage;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// A photo of the plane z = 10, taken from (x, 0, 0) along z, brighter by `exposure`. It sees the plane where
/// X is at most `until`.
CoarsePhoto photo_of_plane(double x, float exposure, double until = 1e9) {
    CoarsePhoto photo;
    photo.k = {96, 64, 80, 80, 48, 32};
    photo.pose.t = {-x, 0, 0};
    const auto light_at = [&](double X, double Y) {
        const auto light = float(exposure * (0.2 + 0.1 * std::sin(X) * std::cos(Y)));
        return X <= until ? light : std::numeric_limits<float>::quiet_NaN();
    };
    const auto plane = [&](double u, double v) {
        return std::array{x + (u - photo.k.cx) / photo.k.fx * 10, (v - photo.k.cy) / photo.k.fy * 10};
    };
    for (int v = 0; v < photo.k.height; ++v)
        for (int u = 0; u < photo.k.width; ++u) {
            const auto [X, Y] = plane(u + 0.5, v + 0.5);
            const float c = light_at(X, Y);
            photo.texels.push_back({{c, c, c}, {c, c, c}, X <= until ? 10.0f : infinite, 1});
        }
    photo.fine_width = 2 * photo.k.width;
    photo.fine_height = 2 * photo.k.height;
    for (int v = 0; v < photo.fine_height; ++v)
        for (int u = 0; u < photo.fine_width; ++u) {
            const auto [X, Y] = plane((u + 0.5) / 2, (v + 0.5) / 2);
            const float c = light_at(X, Y);
            photo.fine.push_back({c, c, c});
        }
    return photo;
}

/// A target between two photos, of which the second is brighter and ends in the middle.
struct TwoPhotos {
    CoarsePhoto target = photo_of_plane(0, 1), left = photo_of_plane(-0.5, 1),
                right = photo_of_plane(0.5, 1.5f, 0);
    Sightings seen =
        sightings(target, std::array{OtherPhoto{0, &left, left.pose}, OtherPhoto{1, &right, right.pose}});
    std::vector<std::array<double, 3>> gains{{0, 0, 0}, {-std::log(1.5), -std::log(1.5), -std::log(1.5)}};

    JudgeScore score_of(const Alternative& alternative) const {
        return score(own_color(target), std::array{predict(target, seen, alternative)}).front();
    }
};

}  // namespace

TEST(Prediction, PhotosOfEqualExposurePredictTheTarget) {
    const CoarsePhoto target = photo_of_plane(0, 1), left = photo_of_plane(-0.5, 1),
                      right = photo_of_plane(0.5, 1);
    const auto seen =
        sightings(target, std::array{OtherPhoto{0, &left, left.pose}, OtherPhoto{1, &right, right.pose}});
    const auto scores = score(own_color(target), std::array{predict(target, seen, {})});
    EXPECT_GT(scores[0].psnr, 55);
    EXPECT_GT(scores[0].ssim, 0.999);
    EXPECT_LT(scores[0].seams, 0.01);
}

TEST(Prediction, PaintedSeamIsMeasuredAndMendedByGains) {
    const TwoPhotos two;
    const JudgeScore without = two.score_of({}), with = two.score_of({.ln_gain = two.gains});
    EXPECT_GT(without.seams, 0.05);
    EXPECT_LT(with.seams, 0.1 * without.seams);
    EXPECT_GT(with.psnr, without.psnr + 10);
}

TEST(Prediction, ContradictedTexelsAreLeftOut) {
    TwoPhotos two;
    // A passer-by in the left photo.
    std::vector<std::uint8_t> weights(two.left.texels.size(), 255);
    for (int y = 20; y < 40; ++y)
        for (int x = 20; x < 40; ++x) {
            const std::size_t at = std::size_t(y * two.left.k.width + x);
            for (float& l : two.left.texels[at].linear) l = 0.9f;
            for (const int i : {0, 1, two.left.fine_width, two.left.fine_width + 1})
                two.left.fine[std::size_t(2 * y * two.left.fine_width + 2 * x + i)].fill(0.9f);
            weights[at] = 1;
        }
    two.seen = sightings(two.target, std::array{OtherPhoto{0, &two.left, two.left.pose},
                                                OtherPhoto{1, &two.right, two.right.pose}});
    const std::array<Grid<const std::uint8_t>, 2> maps{
        Grid<const std::uint8_t>{weights.data(), two.left.k.width, two.left.k.height}, {}};
    const Alternative without{.ln_gain = two.gains};
    Alternative with = without;
    with.consensus = maps;
    EXPECT_GT(two.score_of(with).psnr, two.score_of(without).psnr + 5);
}

TEST(Prediction, PhotosBehindTheSurfaceAndBehindTheCameraAreNotSeen) {
    const CoarsePhoto target = photo_of_plane(0, 1);
    CoarsePhoto behind = photo_of_plane(0, 1);
    behind.pose.t = {0, 0, -20};  // looks away from the plane
    const Sightings seen = sightings(target, std::array{OtherPhoto{0, &behind, behind.pose}});
    EXPECT_TRUE(seen.all.empty());
    const auto scores = score(own_color(target), std::array{predict(target, seen, {})});
    EXPECT_EQ(scores[0].pixels, 0u);
    EXPECT_EQ(scores[0].psnr, 0);
    EXPECT_EQ(scores[0].seams, 0);
}
