#include "player/interface/docked.h"

#include <algorithm>

namespace vantage {

void begin_docked(const char* name, const Area& area, ImVec2 padding, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(ImVec2(float(area.left), float(area.top)));
    ImGui::SetNextWindowSize(ImVec2(float(area.width), float(area.height)));
    ImGui::SetNextWindowBgAlpha(1);  // the picture would tint it
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | flags);
    ImGui::PopStyleVar(2);
}

void keep_within(const Area& area) {
    const ImVec2 at = ImGui::GetWindowPos();
    const float right = float(area.left + area.width) - ImGui::GetWindowWidth();
    const ImVec2 inside(std::max(std::min(at.x, right), float(area.left)), std::max(at.y, float(area.top)));
    if (inside.x != at.x || inside.y != at.y) ImGui::SetWindowPos(inside);
}

ImGuiWindowFlags reading_panel(const WindowState& window) {
    const ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse;
    return ImGuiWindowFlags_AlwaysAutoResize | (window.kiosk ? fixed : ImGuiWindowFlags_None);
}

}  // namespace vantage
