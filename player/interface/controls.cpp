#include "player/interface/controls.h"

#include <cstdio>
#include <fstream>
#include <vector>

namespace vantage::controls {
namespace {

struct Place {
    std::string name;
    ImVec2 low, high;
};
std::vector<Place> places;
long frame = 0;

}  // namespace

void begin_frame() {
    places.clear();
    ++frame;
}

void note(const char* name) { places.push_back({name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()}); }

void write_places(const std::filesystem::path& file) {
    const std::filesystem::path part = file.string() + ".part";
    {
        std::ofstream out(part);
        out << "frame\t" << frame << '\n';
        for (const Place& p : places)
            out << p.name << '\t' << p.low.x << '\t' << p.low.y << '\t' << p.high.x - p.low.x << '\t'
                << p.high.y - p.low.y << '\n';
    }
    std::error_code error;
    std::filesystem::rename(part, file, error);
}

bool button(const char* name) {
    const bool pressed = ImGui::Button(name);
    note(name);
    return pressed;
}

bool checkbox(const char* name, bool* value) {
    const bool changed = ImGui::Checkbox(name, value);
    note(name);
    return changed;
}

bool radio(const char* name, int* value, int choice) {
    const bool changed = ImGui::RadioButton(name, value, choice);
    note(name);
    return changed;
}

bool slider(const char* name, int* value, int low, int high) {
    const bool changed = ImGui::SliderInt(name, value, low, high, "%d", ImGuiSliderFlags_AlwaysClamp);
    note(name);
    return changed;
}

bool slider(const char* name, double* value, double low, double high, const char* format,
            ImGuiSliderFlags flags) {
    const bool changed = ImGui::SliderScalar(name, ImGuiDataType_Double, value, &low, &high, format,
                                             flags | ImGuiSliderFlags_AlwaysClamp);
    note(name);
    return changed;
}

bool combo(const char* name, int* value, const char* const names[], int count) {
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

bool menu_item(const char* name, const char* key, bool selected) {
    const bool pressed = ImGui::MenuItem(name, key, selected);
    note(name);
    return pressed;
}

}  // namespace vantage::controls
