#include "player/interface/tour/caption.h"

#include <imgui.h>

#include <algorithm>

namespace vantage {
namespace {

/// Centers a text that fits on one line.
void caption_line(const std::string& text, float scale) {
    if (text.empty()) return;
    ImGui::SetWindowFontScale(scale);
    const float left = (ImGui::GetWindowWidth() - ImGui::CalcTextSize(text.c_str()).x) / 2;
    ImGui::SetCursorPosX(std::max(left, ImGui::GetStyle().WindowPadding.x));
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace

void caption(Controls& c, const std::string& title, const std::string& text, const Area& free) {
    const float em = ImGui::GetFontSize(), wide = float(free.width),
                width = std::min(std::max(0.5f * wide, 36 * em), wide - 2 * em);
    ImGui::SetNextWindowPos(ImVec2(float(free.left) + wide / 2, float(free.top + free.height) - 2 * em),
                            ImGuiCond_Always, ImVec2(0.5f, 1));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, 0.6f * float(free.height)));
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::Begin("##caption", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    caption_line(title, 1.6f);
    caption_line(text, 1.2f);
    c.note("Caption");
    ImGui::End();
}

}  // namespace vantage
