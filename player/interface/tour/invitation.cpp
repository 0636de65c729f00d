#include "player/interface/tour/invitation.h"

#include <imgui.h>

#include "base/text/translation.h"

namespace vantage {
namespace {

void centered(const char* text) {
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - ImGui::CalcTextSize(text).x) / 2);
    ImGui::TextUnformatted(text);
}

}  // namespace

void invitation(Controls& c, const std::string& title, const Area& free) {
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(float(free.left + free.width / 2), float(free.top + free.height) - 2 * em),
                            ImGuiCond_Always, ImVec2(0.5f, 1));
    ImGui::SetNextWindowSize(ImVec2(0.5f * float(free.width), 0));
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::Begin("##invitation", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::SetWindowFontScale(1.6f);
    if (!title.empty()) centered(title.c_str());
    ImGui::SetWindowFontScale(1.2f);
    centered(tr("Touch to begin"));
    c.note("Invitation");
    ImGui::End();
}

}  // namespace vantage
