#include "player/panels/picture_text.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

#include "player/panels/text_font.h"

namespace vantage {
namespace {

/// Calls `found` for each glyph with its position. Returns the end of the text.
float each_letter(const ImFont& font, const std::string& text,
                  const std::function<void(const ImFontGlyph& letter, float x)>& found) {
    float x = 0;
    const char *at = text.data(), *end = at + text.size();
    while (at < end) {
        unsigned code = 0;
        at += ImTextCharFromUtf8(&code, at, end);
        const ImFontGlyph* letter = font.FindGlyph(ImWchar(code));
        if (!letter) continue;
        found(*letter, x);
        x += letter->AdvanceX;
    }
    return x;
}

}  // namespace

PictureText::PictureText(int line) : line_(line), fonts_(std::make_unique<ImFontAtlas>()) {
    fonts_->Flags |= ImFontAtlasFlags_NoBakedLines | ImFontAtlasFlags_NoMouseCursors;
    ImFontConfig config;
    config.OversampleH = config.OversampleV = 1;  // texels are pixels
    config.PixelSnapH = true;
    config.SizePixels = float(line);
    add_text_font(*fonts_, config);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    fonts_->GetTexDataAsAlpha8(&pixels, &width, &height);
}

PictureText::~PictureText() = default;

int PictureText::width(const std::string& text) const {
    return int(std::ceil(each_letter(*fonts_->Fonts[0], text, [](const ImFontGlyph&, float) {})));
}

void PictureText::draw(const std::string& text, int x, int y,
                       const std::function<void(int, int, std::uint8_t)>& put) const {
    const auto texel = [](float share, int size) { return int(std::lround(share * float(size))); };
    each_letter(*fonts_->Fonts[0], text, [&](const ImFontGlyph& letter, float begin) {
        const int left = texel(letter.U0, fonts_->TexWidth), right = texel(letter.U1, fonts_->TexWidth),
                  top = texel(letter.V0, fonts_->TexHeight), bottom = texel(letter.V1, fonts_->TexHeight);
        const int to_x = x + int(std::lround(begin + letter.X0)), to_y = y + int(std::lround(letter.Y0));
        for (int v = top; v < bottom && letter.Visible; ++v)
            for (int u = left; u < right; ++u)
                if (const std::uint8_t covered = fonts_->TexPixelsAlpha8[v * fonts_->TexWidth + u])
                    put(to_x + u - left, to_y + v - top, covered);
    });
}

}  // namespace vantage
