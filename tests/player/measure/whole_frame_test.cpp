#include "player/measure/whole_frame.h"

#include <gtest/gtest.h>

#include "tests/player/measure/waves.h"

using namespace vantage;

namespace {

constexpr int width = 64, height = 48;

/// The photo is half as bright as the colored lower half of the picture; the upper half is a hole.
struct HalfAHole {
    Picture photo = waves(width, height), shown = photo;
    std::vector<bool> taken = std::vector<bool>(std::size_t(width) * height, true), colored = taken;
    HalfAHole() {
        for (std::size_t i = 0; i < colored.size(); ++i) {
            colored[i] = i >= colored.size() / 2;
            for (std::size_t c = 0; c < 3 && colored[i]; ++c) {
                photo.rgba[4 * i + c] /= 2;
                shown.rgba[4 * i + c] = std::uint8_t(2 * photo.rgba[4 * i + c]);
            }
        }
    }
    FrameScore score() const {
        const std::array<double, 3> gain{0.5, 0.5, 0.5};
        return score_frame(photo, shown, taken, colored, gain,
                           squared_errors(photo, shown, taken, colored, gain));
    }
};

}  // namespace

TEST(WholeFrame, GainAppliesToColoredPixelsOnly) {
    const FrameScore s = HalfAHole().score();
    EXPECT_EQ(s.pixels, std::size_t(width) * height);
    EXPECT_GT(s.psnr_gain, 100);
    EXPECT_GT(s.ssim_gain, 0.999);
    EXPECT_LT(s.psnr, 20);
    EXPECT_LT(s.ssim, 0.95);
}

TEST(WholeFrame, HolesCount) {
    HalfAHole half;
    for (std::size_t i = 0; i < half.shown.rgba.size() / 2; ++i) half.shown.rgba[i] = i % 4 < 3 ? 0 : 255;
    EXPECT_LT(half.score().psnr_gain, 12);
    EXPECT_LT(half.score().ssim_gain, 0.6);
}

TEST(WholeFrame, WhatThePhotoLacksDoesNotCount) {
    HalfAHole half;
    for (std::size_t i = 0; i < half.taken.size() / 2; ++i) {
        half.taken[i] = false;
        half.shown.rgba[4 * i] = std::uint8_t(~half.shown.rgba[4 * i]);
    }
    EXPECT_EQ(half.score().pixels, std::size_t(width) * height / 2);
    EXPECT_GT(half.score().psnr_gain, 100);
}
