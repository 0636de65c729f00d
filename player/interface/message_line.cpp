#include "player/interface/message_line.h"

#include <imgui.h>

#include <utility>

namespace vantage {

void message_line(Controls& c, Session& s, double now) {
    if (s.message.empty()) return;
    // The frame in which it was said may have been a long one.
    if (!std::exchange(s.message_shown, true)) s.message_until = now + message_seconds;
    if (now > s.message_until) return s.message.clear();
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
