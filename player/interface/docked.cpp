#include "player/interface/docked.h"

namespace vantage {

void begin_docked(const char* name, const Area& area, ImVec2 padding, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(ImVec2(float(area.left), float(area.top)));
    ImGui::SetNextWindowSize(ImVec2(float(area.width), float(area.height)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | flags);
    ImGui::PopStyleVar(2);
}

}  // namespace vantage
