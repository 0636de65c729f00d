#include "pipeline/refine/prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "base/values/srgb.h"

using namespace vantage;

namespace {

constexpr float infinite_float = std::numeric_limits<float>::infinity();

/// A photo of the plane z = 10, taken from (x, 0, 0) along z and brightened by the factor `exposure`. It
/// shows the plane where X is at most `until`.
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
            photo.texels.push_back({{c, c, c}, {c, c, c}, X <= until ? 10.0f : infinite_float, 1});
        }
    const int fine_width = 2 * photo.k.width, fine_height = 2 * photo.k.height;
    std::vector<std::array<float, 3>> fine;
    for (int v = 0; v < fine_height; ++v)
        for (int u = 0; u < fine_width; ++u) {
            const auto [X, Y] = plane((u + 0.5) / 2, (v + 0.5) / 2);
            const float c = light_at(X, Y);
            fine.push_back({c, c, c});
        }
    photo.means = square_means(fine, fine_width, fine_height);
    return photo;
}

/// A target between two photos. The second photo is brighter and shows only half of the plane.
struct PhotosBesideTarget {
    CoarsePhoto target = photo_of_plane(0, 1), left = photo_of_plane(-0.5, 1),
                right = photo_of_plane(0.5, 1.5f, 0);
    Sightings seen =
        sightings(target, std::array{OtherPhoto{0, &left, left.pose}, OtherPhoto{1, &right, right.pose}});
    std::vector<std::array<double, 3>> gains{{0, 0, 0}, {-std::log(1.5), -std::log(1.5), -std::log(1.5)}};

    ValidationScore score_of(const Alternative& alternative) const {
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
    const PhotosBesideTarget two;
    const ValidationScore without = two.score_of({}), with = two.score_of({.ln_gain = two.gains});
    EXPECT_GT(without.seams, 0.05);
    EXPECT_LT(with.seams, 0.1 * without.seams);
    EXPECT_GT(with.psnr, without.psnr + 10);
}

TEST(Prediction, ContradictedTexelsAreSkipped) {
    PhotosBesideTarget two;
    // The left photo shows a passer-by, who is masked.
    std::vector<std::uint8_t> weights(two.left.texels.size(), 255);
    for (int y = 20; y < 40; ++y)
        for (int x = 20; x < 40; ++x) {
            const std::size_t at = std::size_t(y * two.left.k.width + x);
            for (float& l : two.left.texels[at].linear) l = 0.9f;
            SquareMeans& means = two.left.means;
            for (const int i : {0, 1, means.width, means.width + 1})
                means.colors[std::size_t(2 * y * means.width + 2 * x + i)].fill(0.9f);
            weights[at] = 1;
        }
    two.seen = sightings(two.target, std::array{OtherPhoto{0, &two.left, two.left.pose},
                                                OtherPhoto{1, &two.right, two.right.pose}});
    const std::array<Grid<const std::uint8_t>, 2> maps{
        Grid<const std::uint8_t>{weights.data(), two.left.k.width, two.left.k.height}, {}};
    const Alternative without{.ln_gain = two.gains};
    Alternative with = without;
    with.transients = maps;
    EXPECT_GT(two.score_of(with).psnr, two.score_of(without).psnr + 5);
}

TEST(Prediction, PhotosBehindTheSurfaceAndBehindTheCameraAreNotSeen) {
    const CoarsePhoto target = photo_of_plane(0, 1);
    CoarsePhoto behind = photo_of_plane(0, 1);
    behind.pose.t = {0, 0, -20};  // faces away from the plane
    const Sightings seen = sightings(target, std::array{OtherPhoto{0, &behind, behind.pose}});
    EXPECT_TRUE(seen.all.empty());
    const auto scores = score(own_color(target), std::array{predict(target, seen, {})});
    EXPECT_EQ(scores[0].pixels, 0u);
    EXPECT_EQ(scores[0].psnr, 0);
    EXPECT_EQ(scores[0].seams, 0);
}

TEST(SquareMeans, GiveTheMeanAroundAnyPosition) {
    // Red increases along x, and green along y, so the mean over a square is the value at its center.
    std::vector<std::array<float, 3>> colors;
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) colors.push_back({float(x) + 0.5f, float(y) + 0.5f, 1});
    const SquareMeans means = square_means(colors, 8, 6);
    for (const auto& [x, y] : {std::pair{1.0f, 1.0f}, {1.3f, 2.2f}, {3.4f, 0.6f}}) {
        const Eigen::Array4f c = means.around(x, y);  // in squares of two texels
        EXPECT_NEAR(c[0], 2 * x, 1e-5);
        EXPECT_NEAR(c[1], 2 * y, 1e-5);
        EXPECT_NEAR(c[2], 1, 1e-6);
    }
    EXPECT_NEAR(means.around(0, 0)[0], 0.5, 1e-6) << "at the edge of the frame, only texels inside count";
    EXPECT_NEAR(means.around(4, 3)[0], 7.5, 1e-6);
    EXPECT_TRUE(square_means({}, 0, 0).colors.empty());
}

TEST(Prediction, EverySecondTexelIsPredictedAsAllAre) {
    const PhotosBesideTarget two;
    const CoarsePhoto some = every_second_texel(two.target);
    ASSERT_EQ(some.texels.size() * 4, two.target.texels.size());
    const Sightings seen = sightings(
        some, std::array{OtherPhoto{0, &two.left, two.left.pose}, OtherPhoto{1, &two.right, two.right.pose}});
    const cv::Mat all = predict(two.target, two.seen, {}).color, part = predict(some, seen, {}).color;
    for (int y = 0; y < part.rows; ++y)
        for (int x = 0; x < part.cols; ++x) {
            const float expected = all.at<cv::Vec3f>(2 * y, 2 * x)[0], found = part.at<cv::Vec3f>(y, x)[0];
            if (std::isfinite(expected))
                EXPECT_NEAR(found, expected, 0.3) << x << ' ' << y;
            else
                EXPECT_FALSE(std::isfinite(found)) << x << ' ' << y;
        }
}

TEST(Prediction, WhatIsOverexposedStaysWhiteInADarkerExposure) {
    const CoarsePhoto target = photo_of_plane(0, 1), other = photo_of_plane(-0.5, 1);
    Sightings seen = sightings(target, std::array{OtherPhoto{0, &other, other.pose}});
    const std::vector<std::array<double, 3>> half{{std::log(0.5), std::log(0.5), std::log(0.5)}};
    const Alternative darker{.ln_gain = half};
    const auto code_of_all = [&](float root) {
        for (Sighting& s : seen.all)
            for (float& channel : s.root) channel = root;
        return predict(target, seen, darker).color.at<cv::Vec3f>(32, 48)[0];
    };
    for (Sighting& s : seen.all) s.theta = 1;
    EXPECT_NEAR(code_of_all(1), 255, 0.1);
    EXPECT_NEAR(code_of_all(std::sqrt(0.8f)), 255 * srgb_from_linear(0.4), 0.2) << "not overexposed";
    for (Sighting& s : seen.all) s.theta = 0;
    EXPECT_NEAR(code_of_all(1), 255 * srgb_from_linear(0.5), 0.2) << "a photo's own view keeps its exposure";
}
