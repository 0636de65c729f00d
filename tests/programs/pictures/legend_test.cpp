// Tests the legend of a scalar field in pictures from the command line.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/text/error.h"
#include "player/pictures/picture_legend.h"
#include "scene/package/contents/color_map.h"
#include "tests/made_scenes.h"
#include "tests/programs/run_program.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

class Legend : public TemporaryFolder {
  protected:
    void SetUp() override {
        TemporaryFolder::SetUp();
        copy_scene(tiny_spec(), dir / "scene");
        copy_package(dir / "scene", {}, dir / "scene.vantage");
    }
    Picture picture(const std::string& options) const {
        const Outcome o = run_command(VANTAGE_PLAYER " render " + (dir / "scene.vantage").string() +
                                          " -q --photo 0001 --field photo-count -o " +
                                          (dir / "p.png").string() + " " + options,
                                      dir);
        EXPECT_EQ(o.code, 0) << o.err;
        return read_png(dir / "p.png");
    }
};

/// The bounding box (left, top, right, bottom) of the differences between two pictures of the same size.
std::array<int, 4> difference(const Picture& a, const Picture& b) {
    std::array<int, 4> out{a.width, a.height, -1, -1};
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const auto at = std::ptrdiff_t(4) * (std::ptrdiff_t(y) * a.width + x);
            if (std::equal(a.rgba.begin() + at, a.rgba.begin() + at + 4, b.rgba.begin() + at)) continue;
            out = {std::min(out[0], x), std::min(out[1], y), std::max(out[2], x), std::max(out[3], y)};
        }
    return out;
}

/// The largest number of colors from a color map that occur in order in a row of the picture.
std::size_t colors_in_a_row(const Picture& p, const ColorTable& table) {
    std::size_t most = 0;
    for (int y = 0; y < p.height; ++y) {
        std::size_t next = 0;
        for (int x = 0; x < p.width; ++x) {
            const std::uint8_t* pixel = &p.rgba[4 * (std::size_t(y) * std::size_t(p.width) + std::size_t(x))];
            for (std::size_t i = next; i < std::min(next + 4, table.size()); ++i)
                if (std::equal(pixel, pixel + 3, table[i].begin())) next = i + 1;
        }
        most = std::max(most, next);
    }
    return most;
}

}  // namespace

TEST_F(Legend, IsInTheLowerLeftCornerOfPicturesThatAreLargeEnough) {
    const Picture with = picture("--size 480x320"), off = picture("--size 480x320 --legend off");
    const auto [left, top, right, bottom] = difference(with, off);
    EXPECT_LT(left, 20);
    EXPECT_GT(bottom, 300);
    EXPECT_LT(right, 240);
    EXPECT_GT(top, 210);
    EXPECT_GE(colors_in_a_row(with, color_table(ColorMap::viridis)), 250u);
    EXPECT_LT(colors_in_a_row(off, color_table(ColorMap::viridis)), 200u);
    EXPECT_EQ(picture("--size 200x150").rgba, picture("--size 200x150 --legend off").rgba) << "too small";
    EXPECT_EQ(picture("--size 480x320 --stereo side-by-side").rgba,
              picture("--size 480x320 --stereo side-by-side --legend off").rgba);
}

TEST(PictureLegend, IsLaidOverWhatIsTransparentAndNeedsRoom) {
    Picture p{800, 600, std::vector<std::uint8_t>(std::size_t(800 * 600 * 4)), {}};
    ScalarField field{.name = "deviation-from-2019", .values = {}};
    field.low = -0.25, field.high = 0.25;
    EXPECT_STREQ(unit_of(field), "input units");
    PictureLegend legend;
    ASSERT_TRUE(legend.draw(p, field, {}));
    EXPECT_GE(colors_in_a_row(p, color_table(ColorMap::coolwarm)), 150u);
    std::size_t shown = 0, opaque = 0;
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) {
        shown += p.rgba[i] > 0, opaque += p.rgba[i] == 255;
        EXPECT_TRUE(p.rgba[i] == 0 || p.rgba[i] >= 204);
    }
    EXPECT_GT(opaque, 2000u) << "the color map";
    EXPECT_GT(shown, 3 * opaque);
    const std::vector<std::uint8_t> before = p.rgba;
    field.name = std::string(300, 'x');
    EXPECT_FALSE(legend.draw(p, field, {}))
        << "a legend whose name is too long for the picture should not be drawn";
    EXPECT_EQ(p.rgba, before);
    Picture small{60, 40, std::vector<std::uint8_t>(std::size_t(60 * 40 * 4)), {}};
    EXPECT_FALSE(legend.draw(small, field, {}));
}
