#pragma once
#include <imgui.h>

#include "player/view/view.h"

namespace vantage {

/// Begins an opaque ImGui window that fills an area of the layout and cannot be moved. ImGui::End() must
/// follow.
void begin_docked(const char* name, const Area& area, ImVec2 padding, ImGuiWindowFlags flags);

/// Moves the current ImGui window into an area if its upper left corner or its right side is outside.
void keep_within(const Area& area);

}  // namespace vantage
