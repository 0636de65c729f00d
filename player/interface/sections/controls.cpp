#include "player/interface/sections/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>

#include "base/files/replace_file.h"
#include "base/text/localized.h"
#include "base/text/translation.h"
#include "player/interface/keyboard_navigation.h"

namespace vantage {

std::string shown_name(const char* name) {
    const std::string translated = tr(name), plain = without_context(name);
    return translated == plain ? plain : translated + "###" + plain;
}

namespace {

/// Shows the number as localized() writes it, instead of ImGui's text. Numbers that are tiny in the slider's
/// range are noise, and shown as 0.
bool localized_slider(const std::string& label, double* value, const std::array<double, 2>& range,
                      const char* format, ImGuiSliderFlags flags) {
    const ImVec2 low = ImGui::GetCursorScreenPos(),
                 high(low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight());
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
    const bool changed =
        ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, value, &range[0], &range[1], format,
                            flags | ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
    ImGui::PopStyleColor();
    const bool noise = std::abs(*value) < 1e-9 * std::max(std::abs(range[0]), std::abs(range[1]));
    const std::string text = localized(format, noise ? 0.0 : *value),
                      name = label.substr(0, label.find("##"));
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float beside = (high.x - low.x - ImGui::CalcTextSize(text.c_str()).x) / 2;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, high, true);
    list.AddText(ImVec2(low.x + std::max(0.0f, beside), low.y + style.FramePadding.y), color, text.c_str());
    list.PopClipRect();
    list.AddText(ImVec2(high.x + style.ItemInnerSpacing.x, low.y + style.FramePadding.y), color,
                 name.c_str());
    return changed;
}

/// Returns 1 to reject a typed character.
int only_numbers(ImGuiInputTextCallbackData* data) {
    return data->EventChar > 127 || !std::strchr("0123456789.,+-eE", int(data->EventChar));
}

bool number_field(const std::string& label, double* value, const char* format) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%s", localized(format, *value).c_str());
    if (!ImGui::InputText(label.c_str(), text.data(), text.size(),
                          ImGuiInputTextFlags_CallbackCharFilter | ImGuiInputTextFlags_AutoSelectAll,
                          only_numbers))
        return false;
    const std::optional<double> typed = typed_number(text.data());
    const bool changed = typed && *typed != *value;
    if (changed) *value = *typed;
    return changed;
}

}  // namespace

void Controls::begin_frame() {
    places_.clear();
    closes_menus_ = false;
    ++frame_;
}

void Controls::note(const char* name) {
    name = without_context(name);
    const char* recorded = std::strstr(name, "##");
    places_.push_back({recorded ? recorded + 2 : name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
}

void Controls::write_places(const std::filesystem::path& file, bool rests) const {
    const UnfinishedFile unfinished(file);  // not synchronized to the disk in every frame
    {
        std::ofstream out(unfinished.part());
        out << "frame\t" << frame_ << (rests ? "\trests\n" : "\tmoves\n");
        for (const Place& p : places_)
            out << p.name << '\t' << p.low.x << '\t' << p.low.y << '\t' << p.high.x - p.low.x << '\t'
                << p.high.y - p.low.y << '\n';
    }
    unfinished.finish();
}

void Controls::explain(const char* text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    // Above or below the item, so that the items beside it stay visible.
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
                 screen = ImGui::GetIO().DisplaySize;
    const float x = std::clamp(ImGui::GetIO().MousePos.x, low.x, high.x), gap = 0.5f * ImGui::GetFontSize();
    const bool above = low.y + high.y > screen.y;
    ImGui::SetNextWindowPos(ImVec2(x, above ? low.y - gap : high.y + gap), ImGuiCond_Always,
                            ImVec2(x / std::max(1.0f, screen.x), above ? 1 : 0));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
    ImGui::TextUnformatted(tr(text));
    ImGui::PopTextWrapPos();
    note("Tooltip");
    ImGui::EndTooltip();
}

void Controls::begin_handle(const char* name, ImVec2 low, ImVec2 size) {
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin((std::string("##") + name).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton("##handle", size);
    note(name);
}

bool Controls::button(const char* name) {
    const bool pressed = ImGui::Button(shown_name(name).c_str());
    note(name);
    return pressed;
}

bool Controls::checkbox(const char* name, bool* value) {
    const bool changed = ImGui::Checkbox(shown_name(name).c_str(), value);
    note(name);
    return changed;
}

bool Controls::radio(const char* name, int* value, int choice) {
    const bool changed = ImGui::RadioButton(shown_name(name).c_str(), value, choice);
    note(name);
    return changed;
}

/// The name to display next to the following control. A name that is too long is shown above the control
/// instead.
std::string Controls::name_beside(const char* name) const {
    const float room =
        ImGui::GetContentRegionAvail().x - ImGui::CalcItemWidth() - ImGui::GetStyle().ItemInnerSpacing.x;
    if (!width_fixed_ || ImGui::CalcTextSize(tr(name), nullptr, true).x <= room) return shown_name(name);
    ImGui::TextUnformatted(tr(name));
    return std::string("##") + without_context(name);
}

bool Controls::slider(const char* name, int* value, int low, int high) {
    const bool changed =
        ImGui::SliderInt(name_beside(name).c_str(), value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
    note(name);
    return changed;
}

bool Controls::slider(const char* name, double* value, double low, double high, const char* format,
                      ImGuiSliderFlags flags) {
    const std::string label = name_beside(name);
    const ImGuiID id = ImGui::GetID(label.c_str());
    bool changed = false;
    if (typed_.id == id) {
        changed = type(label, value, format);
        *value = changed ? std::clamp(*value, low, high) : *value;
    } else {
        changed = localized_slider(label, value, {low, high}, format, flags);
        if (ImGui::IsItemClicked() && ImGui::GetIO().KeyCtrl) typed_ = {id, Typed::frames_to_begin};
    }
    note(name);
    return changed;
}

/// Replaces the text field of ImGui's sliders, which only accepts points.
bool Controls::type(const std::string& label, double* value, const char* format) {
    if (typed_.begins == Typed::frames_to_begin) ImGui::SetKeyboardFocusHere();
    ImGui::PushID("typed");
    const bool changed = number_field(label, value, format);
    ImGui::PopID();
    if (ImGui::IsItemActive())
        typed_.begins = 0;
    else if (typed_.begins-- <= 0)
        typed_ = {};
    return changed;
}

bool Controls::text(const char* name, std::span<char> value) {
    const bool changed = ImGui::InputText(name_beside(name).c_str(), value.data(), value.size());
    note(name);
    return changed;
}

bool Controls::number(const char* name, double* value, const char* format) {
    const bool changed = number_field(name_beside(name), value, format);
    note(name);
    return changed;
}

bool Controls::combo(const char* name, int* value, const char* const names[], int count) {
    return list(name, value, names, count, [](const char* text) { return text; });
}

bool Controls::choice(const char* name, int* value, const char* const texts[], int count) {
    return list(name, value, texts, count, tr);
}

bool Controls::list(const char* name, int* value, const char* const names[], int count,
                    const char* (*in_language)(const char*)) {
    bool changed = false;
    const bool open = ImGui::BeginCombo(name_beside(name).c_str(), in_language(names[*value]));
    note(name);
    if (!open) return false;
    if (closes_menus_) ImGui::CloseCurrentPopup();
    for (int i = 0; i < count; ++i) {
        const bool chosen = ImGui::Selectable(in_language(names[i]), i == *value);
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
    return {2.2f * em + (with_label ? ImGui::CalcTextSize(tr(name)).x + 0.6f * em : 0), 2.2f * em};
}

bool Controls::icon_button(const char* name, Icon icon, bool lit, bool with_label) {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos(), size = icon_button_size(name, with_label),
                 high(low.x + size.x, low.y + size.y);
    const bool pressed = ImGui::InvisibleButton(name, size);
    note((std::string("Bar ") + without_context(name)).c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (ImGui::IsItemActive() || ImGui::IsItemHovered() || lit)
        list.AddRectFilled(low, high,
                           ImGui::GetColorU32(ImGui::IsItemActive()    ? ImGuiCol_ButtonActive
                                              : ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered
                                                                       : ImGuiCol_Header),
                           ImGui::GetStyle().FrameRounding);
    mark_if_navigated();
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    draw_icon(list, icon, ImVec2(low.x + 1.1f * em, low.y + 1.1f * em), 1.25f * em, color);
    if (with_label) list.AddText(ImVec2(low.x + 2.1f * em, low.y + 0.6f * em), color, tr(name));
    return pressed;
}

bool Controls::heading(const char* name, const char* key, bool* more, bool changed) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding, low = ImGui::GetCursorScreenPos(),
                 high(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetFrameHeight());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_Header), ImGui::GetStyle().FrameRounding);
    list.AddText(ImVec2(low.x + padding.x, low.y + padding.y), ImGui::GetColorU32(ImGuiCol_Text), tr(name));
    note((std::string("Section ") + name).c_str(), low, high);
    ImGui::Dummy(ImVec2(0, high.y - low.y));
    float end = high.x;
    const auto button = [&](const char* recorded, const char* label) {
        const float width = ImGui::CalcTextSize(tr(label)).x + 2 * padding.x;
        const bool fits = end - width > low.x + padding.x + ImGui::CalcTextSize(tr(name)).x;
        end = (fits ? end : high.x) - width;
        if (fits) ImGui::SameLine();
        ImGui::SetCursorScreenPos(ImVec2(end, fits ? low.y : ImGui::GetCursorScreenPos().y));
        const bool pressed = ImGui::Button((std::string(tr(label)) + "###" + recorded).c_str());
        note((std::string(recorded) + " " + name).c_str());
        return pressed;
    };
    ImGui::PushID(name);
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    if (more) {
        if (button("More", *more ? marked("Less") : marked("More"))) *more = !*more;
        const std::string text = tr("All controls of this group, or only the main ones");
        explain((*key ? text + " (" + key + ")" : text).c_str());
    }
    const bool resets = changed && button("Reset", marked("Reset"));
    if (changed) explain("Back to the defaults of this group (Ctrl+Z undoes it)");
    ImGui::PopStyleColor();
    ImGui::PopID();
    return resets;
}

bool Controls::menu_item(const char* name, const char* key, bool selected) {
    const bool pressed = ImGui::MenuItem(shown_name(name).c_str(), key && *key ? tr(key) : key, selected);
    note(name);
    return pressed;
}

bool Controls::menu(const char* name) {
    const bool open = ImGui::BeginMenu(shown_name(name).c_str());
    note(name);
    if (open && closes_menus_) ImGui::CloseCurrentPopup();
    return open;
}

bool Controls::popup(const char* name) {
    const bool open = ImGui::BeginPopup(name);
    if (open && closes_menus_) ImGui::CloseCurrentPopup();
    return open;
}

}  // namespace vantage
