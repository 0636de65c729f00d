#pragma once
#include <imgui.h>

namespace vantage {

/// Adds DejaVu Sans if it is installed, and otherwise ImGui's own font, with the letters of all languages
/// that are written in Latin ones. `config`: as ImGui takes it, with the size.
void add_text_font(ImFontAtlas& fonts, const ImFontConfig& config);
/// Builds fonts that only have Latin letters, and shows punctuation that they lack by letters like it.
void replace_missing_letters(ImFontAtlas& fonts);

}  // namespace vantage
