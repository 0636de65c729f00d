#include "player/interface/docked.h"

#include <algorithm>
#include <utility>

namespace vantage {
namespace {

/// How far the current ImGui window must move in this frame to keep its right side in place, if it is in the
/// right half of an area; 0 otherwise.
float growth_to_left(const Area& area) {
    const float width = ImGui::GetWindowWidth();
    float& last = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("width"));
    const float before = std::exchange(last, ImGui::IsWindowAppearing() ? 0 : width);
    const bool at_right = ImGui::GetWindowPos().x + before / 2 > area.left + area.width / 2;
    return before > 0 && last > 0 && at_right ? before - width : 0;
}

}  // namespace

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
    const float growth = growth_to_left(area);
    if (ImGui::IsWindowAppearing()) return;  // its size and place are not known yet
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const float right = float(area.left + area.width) - size.x,
                bottom = float(area.top + area.height) - size.y;
    const ImVec2 inside(std::max(std::min(at.x + growth, right), float(area.left)),
                        std::max(std::min(at.y, bottom), float(area.top)));
    if (inside.x != at.x || inside.y != at.y) ImGui::SetWindowPos(inside);
}

ImGuiWindowFlags reading_panel(const WindowState& window) {
    const ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse;
    return ImGuiWindowFlags_AlwaysAutoResize | (window.kiosk ? fixed : ImGuiWindowFlags_None);
}

}  // namespace vantage
