#include "player/interface/tour/unsaved_changes.h"

#include <imgui.h>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/keys.h"

namespace vantage {
namespace {

constexpr const char* unsaved = marked("Unsaved changes");

bool save_all(Session& s, ActiveStory& active, MeasurePanel& measure, double now) {
    const bool story = !active.changed || save(active, s.message, now);
    return measure.save_unsaved() && story;
}

void questions(const ActiveStory& active, const MeasurePanel& measure) {
    const auto question = [](const char* text, const std::filesystem::path& file) {
        ImGui::TextUnformatted(formatted(text, file.filename().c_str()).c_str());
    };
    if (active.changed) question(tr("Save the changes to the story %s?"), active.file);
    if (measure.failed()) question(tr("Save the measurements in %s?"), measure.file());
    ImGui::Spacing();
}

}  // namespace

void UnsavedChanges::ask(Controls& c, Session& s, ActiveStory& active, MeasurePanel& measure, double now) {
    UserCommands& commands = s.window.commands;
    const std::string name = shown_name(unsaved);
    const bool asked = holds<Quit>(commands) || holds<OpenFile>(commands);
    answered_ &= asked;
    if (asked && !answered_ && !s.window.kiosk && (active.changed || measure.unsaved())) {
        while (auto command = take_one_of<Quit, OpenFile>(commands)) next_ = std::move(command);
        ImGui::OpenPopup(name.c_str());
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (!ImGui::BeginPopupModal(name.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    questions(active, measure);
    // A control that is selected by the arrow keys uses Enter itself.
    const bool entered = take_key(s.window.input, key::enter) || take_key(s.window.input, key::keypad_enter);
    const bool saves = c.button("Save") || (entered && !ImGui::GetIO().NavVisible);
    ImGui::SetItemDefaultFocus();
    ImGui::SameLine();
    const bool discards = c.button("Discard");
    ImGui::SameLine();
    const bool cancels = c.button("Cancel") || take_key(s.window.input, key::escape);
    if (saves || discards || cancels) {
        answered_ = discards || (saves && save_all(s, active, measure, now));
        if (answered_) commands.push_back(std::move(*next_));
        next_.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    if (saves || discards || cancels) ImGui::SetWindowFocus(nullptr);  // releases the keyboard immediately
}

}  // namespace vantage
