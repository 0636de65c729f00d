#include "player/panels/text_font.h"

#include <gtest/gtest.h>

using namespace vantage;

TEST(TextFont, PunctuationThatAFontLacksIsShownByLettersLikeIt) {
    ImFontAtlas fonts;
    fonts.AddFontDefault();
    replace_missing_letters(fonts);
    const ImFont& font = *fonts.Fonts[0];
    for (const int letter : {0x202f, 0x2019, 0x201e, 0x201c, 0x2026}) {
        const ImFontGlyph* const glyph = font.FindGlyphNoFallback(ImWchar(letter));
        ASSERT_TRUE(glyph) << std::hex << letter;
        EXPECT_NE(glyph, font.FindGlyphNoFallback('?')) << std::hex << letter;
    }
    EXPECT_EQ(font.GetCharAdvance(0x202f), font.GetCharAdvance(' '));
}
