#pragma once
#include <imgui.h>

#include "player/interface/state/window_state.h"

namespace vantage {

/// Begins an opaque ImGui window that fills an area of the layout and cannot be moved. ImGui::End() must
/// follow.
void begin_docked(const char* name, const Area& area, ImVec2 padding, ImGuiWindowFlags flags);

/// Moves the current ImGui window into an area if it extends beyond it. In the right half of the area, a
/// window that has become wider or narrower keeps its right side.
void keep_within(const Area& area);

/// The flags of a panel that visitors can read. In a kiosk, they can neither move nor collapse it.
ImGuiWindowFlags reading_panel(const WindowState& window);

}  // namespace vantage
