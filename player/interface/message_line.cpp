#include "player/interface/message_line.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "base/text/translation.h"

namespace vantage {
namespace {

void file_buttons(Controls& c, Message& message, UserCommands& commands, double now) {
    const std::string show = std::string(tr_in("file", "Show")) + "##Show the file";
    if (c.button(show.c_str())) commands.push_back(ShowFolder{message.file.string()});
    c.explain("Opens the folder of the file.");
    ImGui::SameLine();
    if (c.button("Copy path")) ImGui::SetClipboardText(message.file.c_str());
    if (ImGui::IsWindowHovered()) message.until = std::max(message.until, now + 1);
}

}  // namespace

void message_line(Controls& c, Message& message, WindowState& window, double now) {
    if (message.text.empty()) return;
    // The time starts here because the frame that created the message may have taken a long time.
    if (!std::exchange(message.shown, true)) message.until = now + seconds_of(message);
    if (now > message.until) return void(message = {});
    const bool has_buttons = !message.file.empty() && window.keyboard;
    const Area& free = window.free;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(float(free.left + free.width / 2), float(free.top) + em), ImGuiCond_Always,
                            ImVec2(0.5f, 0));
    ImGui::Begin("##message", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     (has_buttons ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoInputs));
    ImGui::PushTextWrapPos(std::max(12 * em, std::min(60 * em, float(free.width) - 4 * em)));
    ImGui::TextUnformatted(message.text.c_str());
    ImGui::PopTextWrapPos();
    c.note("Message");
    if (has_buttons) file_buttons(c, message, window.commands, now);
    if (!window.menu_open) ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImGui::End();
}

}  // namespace vantage
