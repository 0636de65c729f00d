#include "pipeline/costs/picture_costs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/files/png_file.h"
#include "tests/temporary_folder.h"

namespace vantage {
namespace {

constexpr int side = 64;

class PictureCosts : public TemporaryFolder {
  protected:
    /// A checkerboard whose bright squares are brighter by `more`. The first `holes` columns are transparent.
    fs::path picture(const std::string& name, int more, int holes = 0) {
        std::vector<std::uint8_t> rgba;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const bool bright = (x / 2 + y / 2) % 2 != 0;
                for (int c = 0; c < 3; ++c) rgba.push_back(std::uint8_t(bright ? 150 + more : 50));
                rgba.push_back(x < holes ? 0 : 255);
            }
        write_png(dir / name, side, side, rgba);
        return dir / name;
    }
};

TEST_F(PictureCosts, MeasureTheErrorAfterTheBestGain) {
    // Photo (50, 150), picture (50, 170): the best gain is (50^2 + 150 * 170) / (50^2 + 170^2).
    const double gain = (2500 + 150.0 * 170) / (2500 + 170.0 * 170);
    const double error = (std::pow(50 - 50 * gain, 2) + std::pow(150 - 170 * gain, 2)) / 2;
    const PictureDifference d =
        compare_pictures(picture("photo.png", 0), picture("a.png", 20), picture("b.png", 20), false);
    EXPECT_NEAR(d.psnr, 10 * std::log10(255 * 255 / error), 1e-3);
    EXPECT_EQ(d.psnr_difference, 0);
    EXPECT_EQ(d.ssim_difference, 0);
}

TEST_F(PictureCosts, CompareOnlyPixelsThatBothColor) {
    const fs::path photo = picture("photo.png", 0), a = picture("a.png", 20);
    const PictureDifference d = compare_pictures(photo, a, picture("b.png", 20, side / 2), false);
    EXPECT_NEAR(d.psnr_difference, 0, 1e-3) << "holes must not count as errors";
    EXPECT_LT(compare_pictures(photo, a, picture("b.png", 60), false).psnr_difference, -3);
}

TEST_F(PictureCosts, OverTheWholeFrameHolesAreErrors) {
    const fs::path photo = picture("photo.png", 0), a = picture("a.png", 20);
    EXPECT_LT(compare_pictures(photo, a, picture("b.png", 20, side / 2), true).psnr_difference, -3);
}

}  // namespace
}  // namespace vantage
