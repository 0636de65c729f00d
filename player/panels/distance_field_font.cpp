#include "player/panels/distance_field_font.h"

#include <imgui.h>
#include <stb_truetype.h>

#include <algorithm>
#include <cmath>

#include "player/panels/outline_distance.h"
#include "player/panels/text_font.h"

namespace vantage {
namespace {

constexpr float line_texels = 48;
// Distances up to this number of texels are stored. This suffices to antialias text lines with a height of at
// least line_texels / (2 * spread) pixels, which is far too small to read.
constexpr int spread = 8;

void add_font(ImFontAtlas& fonts) {
    ImFontConfig config;
    config.OversampleH = config.OversampleV = 1;  // distances are computed with subtexel accuracy
    config.SizePixels = line_texels;
    add_text_font(fonts, config);
}

/// Draws a glyph at its place in the atlas from its exact curves, because ImGui's polygons deviate by up to a
/// third of a texel, which is visible in large text.
void draw_letter(const stbtt_fontinfo& font, const ImFontGlyph& letter, const ImFontAtlas& fonts,
                 std::vector<std::uint8_t>& coverage) {
    const float scale = stbtt_ScaleForPixelHeight(&font, line_texels);
    const int number = stbtt_FindGlyphIndex(&font, int(letter.Codepoint));
    int left = 0, top = 0, right = 0, bottom = 0;
    stbtt_GetGlyphBitmapBox(&font, number, scale, scale, &left, &top, &right, &bottom);
    const int x = int(std::lround(letter.U0 * float(fonts.TexWidth))),
              y = int(std::lround(letter.V0 * float(fonts.TexHeight)));
    stbtt_vertex* outline = nullptr;
    const int vertices = stbtt_GetGlyphShape(&font, number, &outline);
    if (vertices > 0) {
        stbtt__bitmap bitmap{right - left, bottom - top, fonts.TexWidth,
                             coverage.data() + std::size_t(y) * std::size_t(fonts.TexWidth) + std::size_t(x)};
        constexpr float flatness = 0.01f;  // texels
        stbtt_Rasterize(&bitmap, flatness, outline, vertices, scale, scale, 0, 0, left, top, 1, nullptr);
    }
    stbtt_FreeShape(&font, outline);
}

void draw_letters(const ImFontAtlas& fonts, std::vector<std::uint8_t>& coverage) {
    stbtt_fontinfo font;
    const auto* data = static_cast<const unsigned char*>(fonts.ConfigData[0].FontData);
    if (!stbtt_InitFont(&font, data, stbtt_GetFontOffsetForIndex(data, 0))) return;
    for (const ImFontGlyph& letter : fonts.Fonts[0]->Glyphs)
        if (letter.Visible) draw_letter(font, letter, fonts, coverage);
}

/// The white texels that ImGui uses for filled shapes.
struct White {
    int left, top, right, bottom;
};

White white_texels(const ImFontAtlas& fonts) {
    const int x = int(std::lround(fonts.TexUvWhitePixel.x * float(fonts.TexWidth))),
              y = int(std::lround(fonts.TexUvWhitePixel.y * float(fonts.TexHeight)));
    return {std::max(x - 1, 0), std::max(y - 1, 0), x + 1, y + 1};
}

template <class T>
void fill(std::vector<T>& texels, int width, const White& white, T value) {
    for (int y = white.top; y < white.bottom; ++y)
        for (int x = white.left; x < white.right; ++x)
            texels[std::size_t(y) * std::size_t(width) + std::size_t(x)] = value;
}

/// Enlarges glyph rectangles to include the distance field around their outlines, and adapts texture
/// coordinates to the field, which has more rows than the atlas had.
void enlarge_letters(ImFontAtlas& fonts, const DistanceField& field) {
    const float shrink = float(fonts.TexHeight) / float(field.height);
    const auto by = float(spread);
    for (ImFont* font : fonts.Fonts)
        for (ImFontGlyph& g : font->Glyphs) {
            g.X0 -= by, g.Y0 -= by, g.X1 += by, g.Y1 += by;
            g.U0 -= by / float(field.width), g.U1 += by / float(field.width);
            g.V0 = g.V0 * shrink - by / float(field.height), g.V1 = g.V1 * shrink + by / float(field.height);
        }
    fonts.TexUvWhitePixel.y *= shrink;
    fonts.TexHeight = field.height;
    fonts.TexUvScale.y *= shrink;
}

std::uint16_t packed(float distance) {
    return std::uint16_t(std::lround(65535 * std::clamp(0.5f + distance / (2 * spread), 0.0f, 1.0f)));
}

}  // namespace

void set_text_size(ImFontAtlas& fonts, float text_pixels) {
    for (ImFont* font : fonts.Fonts) font->Scale = text_pixels / font->FontSize;
}

DistanceField build_distance_field_font(ImFontAtlas& fonts, float text_pixels) {
    fonts.Clear();
    fonts.Flags |=
        ImFontAtlasFlags_NoBakedLines | ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoPowerOfTwoHeight;
    fonts.TexGlyphPadding = 2 * spread;
    add_font(fonts);
    unsigned char* pixels = nullptr;
    DistanceField field{.spread = spread, .distances = {}, .coverage = {}};
    int rows = 0;
    fonts.GetTexDataAsAlpha8(&pixels, &field.width, &rows);
    field.height = rows + spread;  // below the lowest glyphs
    field.coverage.assign(pixels, pixels + std::size_t(field.width) * std::size_t(rows));
    field.coverage.resize(std::size_t(field.width) * std::size_t(field.height));
    draw_letters(fonts, field.coverage);
    const White white = white_texels(fonts);
    fill(field.coverage, field.width, white, std::uint8_t(0));
    for (const float d : outline_distances(field.coverage, field.width, field.height, spread))
        field.distances.push_back(packed(d));
    fill(field.coverage, field.width, white, std::uint8_t(255));
    fill(field.distances, field.width, white, std::uint16_t(65535));
    enlarge_letters(fonts, field);
    fonts.ClearTexData();
    set_text_size(fonts, text_pixels);
    return field;
}

}  // namespace vantage
