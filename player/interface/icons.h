#pragma once
#include <imgui.h>

namespace vantage {

/// Icons of the toolbar's buttons.
enum class Icon { home, photos, compare, light, object, share, language, full_screen, help, expert };

/// Draws an icon around `middle`, `size` pixels wide and high.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 middle, float size, ImU32 color);

}  // namespace vantage
