#include "player/interface/sections/open_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "base/text/is_url.h"
#include "base/text/lower_case.h"
#include "base/text/lower_extension.h"
#include "base/text/translation.h"
#include "player/interface/keys.h"
#include "player/interface/state/failure_text.h"
#include "scene/story/scene_file.h"

namespace vantage {
namespace {

constexpr const char* title = marked("Open a package");

int taps(UserInput& input, int key) {
    int n = 0;
    while (take_key(input, key)) ++n;
    return n;
}

}  // namespace

void OpenDialog::list(const std::filesystem::path& folder) {
    std::error_code error;
    folder_ = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
    if (error) folder_ = folder;
    entries_.clear();
    for (std::filesystem::directory_iterator at(folder_, error), end; !error && at != end;
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        std::error_code unknown;
        const bool is_folder = at->is_directory(unknown);
        const bool shown = is_folder ? !name.starts_with('.')
                                     : lower_extension(at->path()) == ".vantage" || is_scene_file(name);
        if (shown) entries_.push_back({name + (is_folder ? "/" : ""), at->path(), is_folder});
    }
    std::ranges::sort(entries_, {},
                      [](const Entry& e) { return std::tuple(!e.folder, lower_case(e.label), e.label); });
    if (folder_.has_relative_path()) entries_.insert(entries_.begin(), {"../", folder_.parent_path(), true});
    trouble_ = error ? failure_text(tr("The folder cannot be read."), error.message()) : "";
    selected_ = entries_.size();
    typed_[0] = 0;
    ++texts_;
    focus_ = true;
}

void OpenDialog::select(std::size_t entry) {
    selected_ = entry;
    std::snprintf(typed_.data(), typed_.size(), "%s", entries_[entry].path.c_str());
    ++texts_;
    focus_ = scroll_ = true;
}

/// Enters the typed or selected folder, or opens the file.
void OpenDialog::accept(WindowState& window) {
    const std::string typed = typed_.data();
    if (typed.empty()) return;
    const std::filesystem::path path = is_url(typed) ? std::filesystem::path(typed) : folder_ / typed;
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return list(path);
    window.commands.push_back(OpenFile{path.string()});
    closes_ = true;
}

void OpenDialog::move_by_keys(WindowState& window) {
    const int by = taps(window.input, key::down) - taps(window.input, key::up), count = int(entries_.size());
    if (by == 0 || count == 0) return;
    const int from = selected_ < entries_.size() ? int(selected_) : by > 0 ? -1 : count;
    select(std::size_t(std::clamp(from + by, 0, count - 1)));
}

void OpenDialog::entries(Controls& c, WindowState& window) {
    ImGui::BeginChild("##entries", ImVec2(520, 260), true);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const char* label = entries_[i].label.c_str();
        const bool chosen = ImGui::Selectable(label, i == selected_, ImGuiSelectableFlags_DontClosePopups);
        const bool doubled = window.input.double_clicked && ImGui::IsItemHovered();
        if (chosen || doubled) select(i);
        if (doubled) {
            accept(window);
            break;  // the list now belongs to another folder
        }
        c.note(label);
        if (scroll_ && i == selected_) ImGui::SetScrollHereY();
    }
    scroll_ = false;
    if (!trouble_.empty()) ImGui::TextUnformatted(trouble_.c_str());
    ImGui::EndChild();
}

void OpenDialog::show(Controls& c, WindowState& window) {
    const bool open = ImGui::IsPopupOpen(shown_name(title).c_str());  // even after a change of scene
    const bool asked = take_all<ChooseFile>(window.commands);
    if (asked || (open && folder_.empty())) list(start_);
    if (asked) ImGui::OpenPopup(shown_name(title).c_str());
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (!ImGui::BeginPopupModal(
            shown_name(title).c_str(), nullptr,
            ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav))  // move_by_keys()
        return;
    closes_ = take_key(window.input, key::escape);
    if (!closes_) content(c, window);
    if (closes_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (closes_) ImGui::SetWindowFocus(nullptr);  // releases the keyboard immediately
}

void OpenDialog::content(Controls& c, WindowState& window) {
    move_by_keys(window);
    ImGui::TextDisabled("%s", folder_.c_str());
    entries(c, window);
    if (focus_) ImGui::SetKeyboardFocusHere();
    focus_ = false;
    ImGui::SetNextItemWidth(520);
    ImGui::PushID(texts_);
    ImGui::InputText("##file", typed_.data(), typed_.size());
    ImGui::PopID();
    c.note("File name");
    const bool entered = take_key(window.input, key::enter) || take_key(window.input, key::keypad_enter);
    if (c.button("Open") || entered) accept(window);
    ImGui::SameLine();
    closes_ |= c.button("Cancel");
}

}  // namespace vantage
