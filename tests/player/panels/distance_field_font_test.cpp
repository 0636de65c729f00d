// Letters have the font's outlines at any position in the atlas.
#include "player/panels/distance_field_font.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <stb_truetype.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

using namespace vantage;

namespace {

constexpr const char* font_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

struct Imgui {
    std::unique_ptr<ImGuiContext, void (*)(ImGuiContext*)> context{ImGui::CreateContext(),
                                                                   &ImGui::DestroyContext};
};

/// The font, read independently of the code under test.
struct Truth {
    Truth() {
        std::ifstream file(font_file, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
        EXPECT_TRUE(stbtt_InitFont(&font, bytes.data(), 0));
    }
    std::vector<unsigned char> bytes;
    stbtt_fontinfo font;
};

/// A letter drawn 32 times as large as in the distance field.
struct Large {
    static constexpr int times = 32;
    Large(const stbtt_fontinfo& font, char letter, float size)
        : pixels(stbtt_GetCodepointBitmap(&font, 0, times * stbtt_ScaleForPixelHeight(&font, size), letter,
                                          &width, &height, &left, &top),
                 [](unsigned char* p) { stbtt_FreeBitmap(p, nullptr); }) {}
    int width, height, left, top;  ///< relative to the letter's origin on the baseline
    std::unique_ptr<unsigned char, void (*)(unsigned char*)> pixels;
};

/// The distance in texels, positive inside, at a position relative to the field's upper left corner.
double distance_at(const DistanceField& field, double x, double y) {
    const int left = int(std::floor(x - 0.5)), top = int(std::floor(y - 0.5));
    const double right = x - 0.5 - left, down = y - 0.5 - top;
    const auto at = [&](int dx, int dy) {
        const std::uint16_t d = field.distances[std::size_t((top + dy) * field.width + left + dx)];
        return (2 * d / 65535.0 - 1) * double(field.spread);
    };
    return (1 - down) * ((1 - right) * at(0, 0) + right * at(1, 0)) +
           down * ((1 - right) * at(0, 1) + right * at(1, 1));
}

}  // namespace

TEST(DistanceFieldFont, OutlinesAreRightToATenthOfATexel) {
    if (!std::filesystem::exists(font_file)) GTEST_SKIP() << "needs DejaVu Sans";
    const Imgui imgui;
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    const DistanceField field = build_distance_field_font(fonts, 25);
    const Truth truth;
    const ImFont& font = *fonts.Fonts[0];
    std::vector<double> errors;
    for (const char letter : std::string("lHoSg&@ae8?")) {
        const Large large(truth.font, letter, font.FontSize);
        const ImFontGlyph& glyph = *font.FindGlyph(ImWchar(letter));
        for (int y = 0; y < large.height; ++y)
            for (int x = 0; x < large.width; ++x) {
                const unsigned char share = large.pixels.get()[y * large.width + x];
                if (share < 96 || share > 160) continue;  // the outline is close to the middle
                const double right = (large.left + x + 0.5) / Large::times - double(glyph.X0),
                             down = (large.top + y + 0.5) / Large::times + std::round(double(font.Ascent)) -
                                    double(glyph.Y0);
                errors.push_back(std::abs(distance_at(field, double(glyph.U0) * field.width + right,
                                                      double(glyph.V0) * field.height + down)));
            }
    }
    ASSERT_GT(errors.size(), 5000u);
    std::ranges::sort(errors);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.1);
    EXPECT_LT(errors.back(), 1);  // at acute corners, which are rounded
}

TEST(DistanceFieldFont, LettersHaveSpaceAroundThem) {
    // The border of each letter's part of the field contains no trace of other letters.
    const Imgui imgui;
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    const DistanceField field = build_distance_field_font(fonts, 25);
    for (const ImFontGlyph& g : fonts.Fonts[0]->Glyphs) {
        if (!g.Visible) continue;
        const double left = double(g.U0) * field.width, right = double(g.U1) * field.width,
                     top = double(g.V0) * field.height, bottom = double(g.V1) * field.height;
        ASSERT_GE(left, 0);
        ASSERT_GE(top, 0);
        ASSERT_LE(right, field.width);
        ASSERT_LE(bottom, field.height);
        for (double x = left + 0.5; x < right; ++x)
            for (const double y : {top + 0.5, bottom - 0.5})
                ASSERT_LT(distance_at(field, std::clamp(x, 0.5, field.width - 1.5),
                                      std::clamp(y, 0.5, field.height - 1.5)),
                          -6)
                    << g.Codepoint;
    }
    const ImVec2 white = fonts.TexUvWhitePixel;
    EXPECT_NEAR(distance_at(field, double(white.x) * field.width, double(white.y) * field.height),
                double(field.spread), 1e-6);
}

TEST(DistanceFieldFont, TextTakesTheSpaceThatItHasInTheFont) {
    if (!std::filesystem::exists(font_file)) GTEST_SKIP() << "needs DejaVu Sans";
    const Imgui imgui;
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    build_distance_field_font(fonts, 25);
    const auto size_of = [&](const char* text) {
        return fonts.Fonts[0]->CalcTextSizeA(fonts.Fonts[0]->FontSize * fonts.Fonts[0]->Scale, 1e9f, 0, text);
    };
    const ImVec2 size = size_of("Hamburgefonstiv");
    set_text_size(fonts, 50);
    const ImVec2 twice = size_of("Hamburgefonstiv");
    const Truth truth;
    int units = 0;
    for (const char c : std::string("Hamburgefonstiv")) {
        int advance = 0, bearing = 0;
        stbtt_GetCodepointHMetrics(&truth.font, c, &advance, &bearing);
        units += advance;
    }
    const float width = float(units) * stbtt_ScaleForPixelHeight(&truth.font, 25);
    EXPECT_NEAR(size.x, width, 1);
    EXPECT_EQ(size.y, 25);
    EXPECT_NEAR(twice.x, 2 * width, 1);
}
