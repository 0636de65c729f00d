#pragma once
#include <imgui.h>

#include "player/camera/view.h"

namespace vantage {

/// Begins an ImGui window that fills a part of the layout and cannot be moved. ImGui::End() must follow.
void begin_docked(const char* name, const Area& area, ImVec2 padding, ImGuiWindowFlags flags);

}  // namespace vantage
