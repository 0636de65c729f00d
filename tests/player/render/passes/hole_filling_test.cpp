// Areas that no photo shows take on the surrounding colors.
#include "player/render/passes/hole_filling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/gl/context.h"
#include "shaders/contract.h"

using namespace vantage;

namespace {

struct Color {
    float red, weight;
    bool background = false;
};

/// The red channel of the filled picture, at half size. Each sample consists of red times its weight, and the
/// weight. `behind`: the colors for holes in the background.
std::vector<float> filled(int width, int height, const std::function<Color(int x, int y)>& drawn,
                          float samples = 1, bool behind = false) {
    const gl::HeadlessContext context;
    const FrameTargets frame = make_frame_targets({width, height});
    std::vector<float> texels, surface;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color c = drawn(x, y);
            texels.insert(texels.end(), {samples * c.weight * c.red, 0, 0, samples * c.weight});
            surface.insert(surface.end(), {0, 0, 0, c.background ? shader::shows_background : 1.0f});
        }
    glTextureSubImage2D(frame.samples.front().sum.id(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT,
                        texels.data());
    glTextureSubImage2D(frame.surface().shaded.id(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT,
                        surface.data());
    HoleFilling filling;
    filling.fit(width, height);
    filling.fill(frame.samples.front().sum, frame.surface().shaded.id(), frame, samples);
    const int w = (width + 1) / 2, h = (height + 1) / 2;
    std::vector<float> out(std::size_t(w) * std::size_t(h));
    glGetTextureImage((behind ? filling.filled_behind() : filling.filled()).id(), 0, GL_RED, GL_FLOAT,
                      GLsizei(4 * out.size()), out.data());
    for (float& root : out) root *= root;
    return out;
}

}  // namespace

TEST(HoleFilling, AHoleInOneColorHasThatColor) {
    for (const auto& [w, h] : {std::pair(64, 48), std::pair(61, 37), std::pair(1, 1), std::pair(1, 9)}) {
        const auto at = [&](int x, int y) {
            const bool hole = x > w / 4 && x < w / 2 && y > h / 4;
            return hole ? Color{0.9f, 0} : Color{0.25f, 1};
        };
        for (const float samples : {1.0f, 4.0f})
            for (const float red : filled(w, h, at, samples)) ASSERT_NEAR(red, 0.25, 1e-5) << w << "x" << h;
    }
}

TEST(HoleFilling, BetweenTwoColorsAHoleGoesFromOneToTheOther) {
    const int w = 128, h = 32;
    const auto at = [](int x, int) { return Color{x < 64 ? 0.2f : 0.8f, x < 32 || x >= 96 ? 1.0f : 0.0f}; };
    const std::vector<float> red = filled(w, h, at);
    const float* row = &red[std::size_t(h / 4) * (w / 2)];
    EXPECT_NEAR(row[8], 0.2, 1e-5);
    EXPECT_NEAR(row[56], 0.8, 1e-5);
    for (int x = 1; x < w / 2; ++x) {
        EXPECT_GE(row[x], row[x - 1] - 1e-5) << x;
        EXPECT_LE(row[x] - row[x - 1], 0.1) << "no edge at " << x;
    }
    EXPECT_NEAR(row[31] + row[32], 1, 0.1);
}

TEST(HoleFilling, BesideTheMeshAHoleOfTheBackgroundHasTheBackgroundsColor) {
    const int w = 128, h = 32;
    const auto at = [](int x, int) {
        return Color{x < 64 ? 0.2f : 0.8f, x < 64 || x >= 80 ? 1.0f : 0.0f, x >= 64};
    };
    const std::size_t middle = std::size_t(h / 4) * (w / 2) + 36;
    EXPECT_NEAR(filled(w, h, at)[middle], 0.5, 0.1);
    EXPECT_GT(filled(w, h, at, 1, true)[middle], 0.62);
}

TEST(HoleFilling, FarFromOtherColorsAHoleHasItsOwn) {
    const int w = 512, h = 256;
    const float weight = HoleFilling::hole_weight(w, h);
    const auto at = [&](int x, int) { return x < 64 ? Color{0.8f, 1} : Color{0.1f, weight}; };
    const std::vector<float> red = filled(w, h, at);
    const float* row = &red[std::size_t(h / 4) * (w / 2)];
    EXPECT_NEAR(row[34], 0.8, 0.1) << "beside other colors";
    EXPECT_NEAR(row[250], 0.1, 0.1) << "far from them";
    const std::vector<float> alone = filled(w, h, [&](int, int) { return Color{0.1f, weight}; });
    EXPECT_NEAR(alone[0], 0.1, 1e-4) << "without any others";
    for (const float r : filled(w, h, [](int, int) { return Color{0, 0}; }))
        ASSERT_EQ(r, 0) << "nothing at all";
}
