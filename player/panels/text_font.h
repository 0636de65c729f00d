#pragma once
#include <imgui.h>

namespace vantage {

/// Adds DejaVu Sans if it is installed, otherwise ImGui's own font, with the letters of all languages in
/// Latin script. `config`: ImGui's settings for the font, including its size.
void add_text_font(ImFontAtlas& fonts, const ImFontConfig& config);
/// Builds fonts that only have Latin letters, and replaces missing punctuation with similar characters.
void replace_missing_letters(ImFontAtlas& fonts);

}  // namespace vantage
