#include "player/interface/message_line.h"

#include <imgui.h>


namespace vantage {

void message_line(const Session& s, double now) {
    if (s.message.empty() || now > s.message_until) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, 44), ImGuiCond_Always, ImVec2(0.5f, 0));
    ImGui::Begin("##message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(s.message.c_str());
    ImGui::End();
}

}  // namespace vantage
