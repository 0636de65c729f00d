#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <random>
#include <span>

#include "player/measure/evaluation/change.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

Picture random_picture(int width, int height, unsigned seed, bool smooth) {
    cv::Mat m(height, width, CV_8UC4);
    cv::RNG random(seed);
    random.fill(m, cv::RNG::UNIFORM, 0, 256);
    if (smooth) cv::GaussianBlur(m, m, {0, 0}, 3);
    if (smooth) cv::normalize(m, m, 0, 255, cv::NORM_MINMAX);
    Picture p{width, height, std::vector<std::uint8_t>(m.datastart, m.dataend), {}};
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) p.rgba[i] = 255;
    return p;
}

cv::Mat rgb(const Picture& p) {
    cv::Mat m(p.height, p.width, CV_8UC4, const_cast<std::uint8_t*>(p.rgba.data())), out;
    cv::cvtColor(m, out, cv::COLOR_RGBA2RGB);
    return out;
}

cv::Mat mask_of(const Picture& p, const std::vector<bool>& flags) {
    cv::Mat m(p.height, p.width, CV_8U);
    for (std::size_t i = 0; i < flags.size(); ++i) m.data[i] = flags[i];
    return m;
}

/// SSIM over a mask, computed by normalized convolution with OpenCV's filters.
double ssim(const Picture& photo, const Picture& picture, const cv::Mat& mask) {
    cv::Mat a, b, m;
    cv::cvtColor(rgb(photo), a, cv::COLOR_RGB2GRAY);
    cv::cvtColor(rgb(picture), b, cv::COLOR_RGB2GRAY);
    a.convertTo(a, CV_64F), b.convertTo(b, CV_64F), mask.convertTo(m, CV_64F);
    const auto blur = [](const cv::Mat& x) {
        cv::Mat out;
        cv::GaussianBlur(x, out, {11, 11}, 1.5, 1.5, cv::BORDER_CONSTANT);
        return out;
    };
    const cv::Mat n = cv::max(blur(m), 1e-9);
    const auto mean = [&](const cv::Mat& x) { return cv::Mat(blur(x.mul(m)) / n); };
    const cv::Mat ma = mean(a), mb = mean(b);
    const cv::Mat va = cv::max(mean(a.mul(a)) - ma.mul(ma), 0), vb = cv::max(mean(b.mul(b)) - mb.mul(mb), 0),
                  c = mean(a.mul(b)) - ma.mul(mb);
    const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
    const cv::Mat top = (2 * ma.mul(mb) + c1).mul(2 * c + c2),
                  bottom = (ma.mul(ma) + mb.mul(mb) + c1).mul(va + vb + c2);
    return cv::mean(top / bottom, mask)[0];
}

class PictureMetricsReference : public TemporaryFolder {};

}  // namespace

TEST(PictureMetrics, AgreeWithOpenCv) {
    for (const bool smooth : {false, true}) {
        const Picture photo = random_picture(97, 61, 1, smooth);
        Picture picture = random_picture(97, 61, 2, smooth);
        for (std::size_t i = 0; i < picture.rgba.size(); ++i)  // similar to the photo
            picture.rgba[i] = std::uint8_t((2 * photo.rgba[i] + picture.rgba[i]) / 3);
        for (int y = 0; y < 61; ++y)
            for (int x = 0; x < 97; ++x)
                if (std::hypot(x - 40, y - 30) > 35) picture.rgba[std::size_t(y * 97 + x) * 4 + 3] = 100;
        const std::vector<bool> scored = scored_pixels(picture);
        cv::Mat solid(61, 97, CV_8U), eroded;
        for (std::size_t i = 0; i < scored.size(); ++i) solid.data[i] = picture.rgba[4 * i + 3] >= 128;
        cv::erode(solid, eroded, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}), {-1, -1}, 1,
                  cv::BORDER_CONSTANT, 1);
        const cv::Mat mask = mask_of(picture, scored);
        EXPECT_EQ(cv::countNonZero(mask != eroded), 0);
        const PictureScore s = score(photo, picture, scored);
        cv::Mat squares;
        cv::Mat difference;
        cv::absdiff(rgb(photo), rgb(picture), difference);
        difference.convertTo(difference, CV_64F);
        const cv::Scalar mse = cv::mean(difference.mul(difference), mask);
        EXPECT_NEAR(s.psnr, 10 * std::log10(255 * 255 / ((mse[0] + mse[1] + mse[2]) / 3)), 1e-9);
        EXPECT_NEAR(s.ssim, ssim(photo, picture, mask), 1e-3);
        EXPECT_EQ(s.pixels, std::size_t(cv::countNonZero(mask)));
    }
}

TEST(PictureMetrics, CompensateForGain) {
    const Picture picture = random_picture(64, 48, 3, true);
    Picture photo = picture;
    const double gain[] = {0.9, 0.7, 0.5};
    for (std::size_t i = 0; i < photo.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            photo.rgba[i + c] = std::uint8_t(std::lround(gain[c] * picture.rgba[i + c]));
    const PictureScore s = score(photo, picture, scored_pixels(picture));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(s.gain[c], gain[c], 2e-3);
    EXPECT_GT(s.psnr_gain, 50);
    EXPECT_LT(s.psnr, 20);
    EXPECT_GT(s.ssim_gain, 0.999);
    EXPECT_LT(s.ssim, 0.95);
}

TEST(PictureMetrics, FindShifts) {
    const cv::Mat wide = rgb(random_picture(300, 200, 4, true));
    for (const auto& [dx, dy] : {std::pair(0.0, 0.0), {0.7, -0.4}, {-1.5, 1.1}}) {
        cv::Mat moved;
        const cv::Mat warp = (cv::Mat_<double>(2, 3) << 1, 0, dx, 0, 1, dy);
        cv::warpAffine(wide, moved, warp, wide.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
        const auto picture = [](const cv::Mat& m) {
            cv::Mat rgba;
            cv::cvtColor(m, rgba, cv::COLOR_RGB2RGBA);
            return Picture{m.cols, m.rows, std::vector<std::uint8_t>(rgba.datastart, rgba.dataend), {}};
        };
        const Picture a = picture(wide), b = picture(moved);
        const auto shift = shift_of(a, b, scored_pixels(a));
        EXPECT_NEAR(shift[0], dx, 0.05 + 0.25 * std::abs(dx));
        EXPECT_NEAR(shift[1], dy, 0.05 + 0.25 * std::abs(dy));
    }
}

TEST(PictureMetrics, EmptyAndFlatPictures) {
    Picture empty = random_picture(20, 10, 5, false);
    for (std::size_t i = 3; i < empty.rgba.size(); i += 4) empty.rgba[i] = 0;
    const PictureScore none = score(empty, empty, scored_pixels(empty));
    EXPECT_EQ(none.pixels, 0u);
    EXPECT_EQ(none.psnr, 0);
    const Picture flat{20, 10, std::vector<std::uint8_t>(800, 255), {}};
    const auto shift = shift_of(flat, flat, scored_pixels(flat));
    EXPECT_EQ(shift[0], 0);
    EXPECT_EQ(shift[1], 0);
    EXPECT_GT(score(flat, flat, scored_pixels(flat)).psnr, 100);
    const Picture black{20, 10, std::vector<std::uint8_t>(800, 0), {}};
    EXPECT_TRUE(std::isfinite(score(flat, black, std::vector<bool>(200, true)).psnr_gain));
}

TEST(PictureMetrics, LocateChanges) {
    const Picture photo = random_picture(400, 300, 11, true);
    const auto spoiled = [&](int left, int top) {
        Picture p = photo;
        for (int y = top; y < top + 40; ++y)
            for (int x = left; x < left + 40; ++x)
                for (int c = 0; c < 3; ++c) p.rgba[std::size_t(4 * (y * p.width + x) + c)] ^= 0x40;
        return p;
    };
    const auto holds = [](const Place& p, int x, int y) {
        return p.x <= x && x < p.x + p.width && p.y <= y && y < p.y + p.height;
    };
    const Picture before = spoiled(30, 200), after = spoiled(310, 20);
    const std::vector<bool> scored = scored_pixels(photo);
    const Change c = change_of(photo, before, after, scored);
    ASSERT_TRUE(c.better && c.worse);
    EXPECT_TRUE(holds(*c.better, 50, 220)) << c.better->x << ' ' << c.better->y;
    EXPECT_TRUE(holds(*c.worse, 330, 40)) << c.worse->x << ' ' << c.worse->y;
    EXPECT_EQ(c.before.psnr_gain, score(photo, before, scored).psnr_gain);
    EXPECT_EQ(c.after.ssim, score(photo, after, scored).ssim);

    const Picture crop = side_by_side(std::array{&photo, &before, &after}, *c.worse);
    EXPECT_EQ(crop.height, c.worse->height);
    const auto texel = [&](int column) {  // at the center of the altered block
        const int y = 40 - c.worse->y, x = 330 - c.worse->x + column * (c.worse->width + 4);
        return std::span(crop.rgba).subspan(std::size_t(4 * (y * crop.width + x)), 3);
    };
    EXPECT_TRUE(std::ranges::equal(texel(0), texel(1)))
        << "the picture before the change should be equal to the photo";
    EXPECT_FALSE(std::ranges::equal(texel(0), texel(2))) << "after: altered";

    const Change none = change_of(photo, before, before, scored);
    EXPECT_FALSE(none.better || none.worse);
}

// The datasets come with an independent implementation.
TEST_F(PictureMetricsReference, AgreeWithinAHundredthOfADecibel) {
    const char* root = std::getenv("VANTAGE_DATASETS");
    const std::filesystem::path kit =
        std::filesystem::path(root ? root : "../shared/datasets") / "../tools/metric.py";
    if (!std::filesystem::exists(kit)) GTEST_SKIP() << "no reference implementation at " << kit;
    const Picture photo = random_picture(181, 133, 5, true);
    Picture picture = random_picture(181, 133, 5, true);
    std::mt19937 random(3);
    for (std::uint8_t& v : picture.rgba) v = std::uint8_t(v * 0.9 + double(random() % 20));
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
        picture.rgba[i] = i > 40000 && i < 42000 ? 0 : 255;
    write_png(dir / "photo.png", photo);
    write_png(dir / "picture.png", picture);
    const std::string command = "python3 " + kit.string() + " " + (dir / "photo.png").string() + " " +
                                (dir / "picture.png").string() + " > " + (dir / "output").string() + " 2>&1";
    if (std::system(("/usr/bin/" + command).c_str()) != 0)
        GTEST_SKIP() << "the reference implementation does not run on this machine: "
                     << slurp(dir / "output");
    const std::string output = slurp(dir / "output");
    const auto value = [&](const std::string& name) {
        return std::stod(output.substr(output.find(name + "=") + name.size() + 1));
    };
    const PictureScore s = score(photo, picture, scored_pixels(picture));
    EXPECT_NEAR(s.psnr, value("psnr"), 0.01);
    EXPECT_NEAR(s.psnr_gain, value("psnr_gain"), 0.01);
    EXPECT_NEAR(s.ssim, value("ssim"), 0.0002);
    EXPECT_NEAR(s.ssim_gain, value("ssim_gain"), 0.0002);
}
