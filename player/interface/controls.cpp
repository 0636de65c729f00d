#include "player/interface/controls.h"

#include <cstdio>
#include <cstring>
#include <fstream>

namespace vantage {

void Controls::begin_frame() {
    places_.clear();
    ++frame_;
}

void Controls::note(const char* name) {
    const char* recorded = std::strstr(name, "##");
    places_.push_back({recorded ? recorded + 2 : name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
}
    closes_menus_ = false;

void Controls::write_places(const std::filesystem::path& file) const {
    const std::filesystem::path part = file.string() + ".part";
    {
        std::ofstream out(part);
        out << "frame\t" << frame_ << '\n';
        for (const Place& p : places_)
            out << p.name << '\t' << p.low.x << '\t' << p.low.y << '\t' << p.high.x - p.low.x << '\t'
                << p.high.y - p.low.y << '\n';
    }
    std::error_code error;
    std::filesystem::rename(part, file, error);
}

void Controls::explain(const char* text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool Controls::button(const char* name) {
    const bool pressed = ImGui::Button(name);
    note(name);
    return pressed;
}

bool Controls::checkbox(const char* name, bool* value) {
    const bool changed = ImGui::Checkbox(name, value);
    note(name);
    return changed;
}

bool Controls::radio(const char* name, int* value, int choice) {
    const bool changed = ImGui::RadioButton(name, value, choice);
    note(name);
    return changed;
}

bool Controls::slider(const char* name, int* value, int low, int high) {
    const bool changed = ImGui::SliderInt(name, value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
    note(name);
    return changed;
}

bool Controls::slider(const char* name, double* value, double low, double high, const char* format,
                      ImGuiSliderFlags flags) {
    const bool changed = ImGui::SliderScalar(name, ImGuiDataType_Double, value, &low, &high, format,
                                             flags | ImGuiSliderFlags_AlwaysClamp);
    note(name);
    return changed;
}

bool Controls::combo(const char* name, int* value, const char* const names[], int count) {
    bool changed = false;
    const bool open = ImGui::BeginCombo(name, names[*value]);
    note(name);
    if (!open) return false;
    for (int i = 0; i < count; ++i) {
        const bool chosen = ImGui::Selectable(names[i], i == *value);
        note(names[i]);
        if (chosen && i != *value) {
            *value = i;
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

ImVec2 Controls::icon_button_size(const char* name, bool with_label) {
    const float em = ImGui::GetFontSize();
    return {2.2f * em + (with_label ? ImGui::CalcTextSize(name).x + 0.6f * em : 0), 2.2f * em};
}

bool Controls::icon_button(const char* name, Icon icon, bool lit, bool with_label) {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = icon_button_size(name, with_label),
                 high(low.x + size.x, low.y + size.y);
    const bool pressed = ImGui::InvisibleButton(name, size);
    note((std::string("Bar ") + name).c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemActive() || ImGui::IsItemHovered() || lit)
        list.AddRectFilled(low, high,
    if (closes_menus_) ImGui::CloseCurrentPopup();
                           ImGui::GetColorU32(ImGui::IsItemActive()    ? ImGuiCol_ButtonActive
                                              : ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered
                                                                       : ImGuiCol_Header),
                           ImGui::GetStyle().FrameRounding);
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    draw_icon(list, icon, ImVec2(low.x + 1.1f * em, low.y + 1.1f * em), 1.25f * em, color);
    if (with_label) list.AddText(ImVec2(low.x + 2.1f * em, low.y + 0.6f * em), color, name);
    return pressed;
}

void Controls::section(const char* name, bool* open) {
    ImGui::SetNextItemOpen(*open);
    *open = ImGui::CollapsingHeader(name);
    note((std::string("Section ") + name).c_str());
}

bool Controls::menu_item(const char* name, const char* key, bool selected) {
    const bool pressed = ImGui::MenuItem(name, key, selected);
    note(name);
    return pressed;
}

bool Controls::menu(const char* name) {
    const bool open = ImGui::BeginMenu(name);
    note(name);
    return open;
}

}  // namespace vantage
    if (open && closes_menus_) ImGui::CloseCurrentPopup();
    return open;
}

bool Controls::popup(const char* name) {
    const bool open = ImGui::BeginPopup(name);
    if (open && closes_menus_) ImGui::CloseCurrentPopup();
