#pragma once

namespace vantage {

inline constexpr float least_text_scale = 0.75f, most_text_scale = 4;

/// Sets ImGui's colors and shapes, and its font to DejaVu Sans if installed. `scale`: of text, and of all
/// that is measured by it; 1 for 14 pixels.
void set_style(float scale);

}  // namespace vantage
