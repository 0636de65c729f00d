#include "player/interface/message_line.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace vantage {

void message_line(Controls& c, Message& message, const Area& free, double now) {
    if (message.text.empty()) return;
    // The time starts here because the frame that created the message may have taken a long time.
    if (!std::exchange(message.shown, true)) message.until = now + message_seconds;
    if (now > message.until) return message.text.clear();
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(float(free.left + free.width / 2), float(free.top) + em), ImGuiCond_Always,
                            ImVec2(0.5f, 0));
    ImGui::Begin("##message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(std::max(12 * em, std::min(60 * em, float(free.width) - 4 * em)));
    ImGui::TextUnformatted(message.text.c_str());
    ImGui::PopTextWrapPos();
    c.note("Message");
    ImGui::End();
}

}  // namespace vantage
