#pragma once

namespace vantage {

/// Limits of the text scale, and the factor per step.
inline constexpr float least_text_scale = 0.7f, max_text_scale = 4, text_step = 1.125f;

/// Sets ImGui's colors and shapes, for text of 14 pixels times `scale`.
void set_look(float scale);

/// Sets ImGui's colors and shapes, and its font to DejaVu Sans if it is installed. `scale`: the scale of text
/// and of sizes derived from it; 1 for 14 pixels.
void set_style(float scale);

}  // namespace vantage
