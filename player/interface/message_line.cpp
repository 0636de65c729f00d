#include "player/interface/message_line.h"

#include <imgui.h>

namespace vantage {

void message_line(Controls& c, const Session& s, double now) {
    if (s.message.empty() || now > s.message_until) return;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(float(s.free.left + s.free.width / 2), float(s.free.top) + em),
                            ImGuiCond_Always, ImVec2(0.5f, 0));
    ImGui::Begin("##message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextUnformatted(s.message.c_str());
    c.note("Message");
    ImGui::End();
}

}  // namespace vantage
