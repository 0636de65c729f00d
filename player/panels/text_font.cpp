#include "player/panels/text_font.h"

#include <filesystem>

namespace vantage {

void add_text_font(ImFontAtlas& fonts, const ImFontConfig& config) {
    static const ImWchar letters[] = {0x20,   0x17f,  0x218,  0x21b,  0x2010, 0x2026, 0x202f,
                                      0x202f, 0x2032, 0x2033, 0x20ac, 0x20ac, 0};
    for (const char* font : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"})
        if (std::filesystem::exists(font)) {
            fonts.AddFontFromFileTTF(font, config.SizePixels, &config, letters);
            return;
        }
    fonts.AddFontDefault(&config);
    replace_missing_letters(fonts);
}

void replace_missing_letters(ImFontAtlas& fonts) {
    struct Replacement {
        ImWchar missing, by;
    };
    fonts.Build();
    for (const auto& [missing, by] :
         {Replacement{0x202f, ' '}, Replacement{0x2019, '\''}, Replacement{0x201e, '"'},
          Replacement{0x201c, '"'}, Replacement{0x2026, 0xb7}})
        for (ImFont* font : fonts.Fonts)
            if (!font->FindGlyphNoFallback(missing)) font->AddRemapChar(missing, by);
}

}  // namespace vantage
