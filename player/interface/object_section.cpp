#include "player/window/object_panel.h"

#include <imgui.h>

#include <filesystem>
#include <string>
#include <utility>

namespace vantage {
namespace {

/// Sliders for where an object stands.
bool placement_sliders(Controls& c, ObjectSet& objects, std::size_t object, double size) {
    Placement p = objects.at(object).placement;
    const std::string of = " of " + objects.at(object).name;
    bool changed = false;
    constexpr const char* axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        changed |= c.slider(("Move " + std::string(axes[axis]) + of).c_str(), &p.move[axis], -2 * size,
                            2 * size, "%.3f");
    for (int axis = 0; axis < 3; ++axis)
        changed |=
            c.slider(("Turn " + std::string(axes[axis]) + of).c_str(), &p.turn[axis], -180, 180, "%.1f");
    changed |= c.slider(("Scale" + of).c_str(), &p.scale, 0.01, 100, "%.3f", ImGuiSliderFlags_Logarithmic);
    if (changed) objects.place(object, p);
    return changed;
}

bool opacity_slider(Controls& c, ObjectSet& objects, std::size_t object) {
    double opacity = objects.at(object).opacity;
    if (!c.slider(("Opacity of " + objects.at(object).name).c_str(), &opacity, 0, 1, "%.2f")) return false;
    objects.set_opacity(object, opacity);
    return true;
}

/// One object's row. Sets `removed` if it is to be removed.
bool object_row(Controls& c, ObjectSet& objects, std::size_t object, double size, bool& removed) {
    const std::string name = objects.at(object).name;
    bool shown = objects.at(object).shown, changed = false;
    if (c.checkbox(name.c_str(), &shown)) objects.show_object(object, shown), changed = true;
    ImGui::SameLine();
    if (c.button(("Only " + name).c_str())) objects.show_only(object), changed = true;
    const std::string position = "Position of " + name;
    bool* open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID((position + " open").c_str()));
    if (object > 0) {
        ImGui::SameLine();
        removed = c.button(("Remove " + name).c_str());
        ImGui::SameLine();
        if (c.button(position.c_str())) *open = !*open;
    }
    changed |= opacity_slider(c, objects, object);
    if (object > 0 && *open) changed |= placement_sliders(c, objects, object, size);
    return changed;
}

}  // namespace

bool object_panel(Controls& c, Session& session, ObjectSet& objects, double size) {
    ImGui::SetNextWindowPos(ImVec2(ImGui::GetIO().DisplaySize.x - 452, 256), ImGuiCond_FirstUseEver);
    bool changed = false;
    std::size_t remove = 0;
    if (ImGui::Begin("Objects", &session.panels.objects, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushItemWidth(190);
        for (std::size_t i = 0; i < objects.size(); ++i) {
            bool removed = false;
            changed |= object_row(c, objects, i, size, removed);
            if (removed) remove = i;
        }
        if (objects.size() == 1) ImGui::TextDisabled("Drop a package on the window to add it.");
        if (c.button("Save scene")) session.save_scene = true;
        ImGui::PopItemWidth();
    }
    ImGui::End();
    if (remove > 0) objects.remove(remove), changed = true;
    return changed;
}

void drop_dialog(Controls& c, Session& session) {
    if (session.dropped.empty()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (ImGui::Begin("Dropped package", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::TextUnformatted(std::filesystem::path(session.dropped).filename().c_str());
        if (c.button("Open in place of the scene")) session.open = std::exchange(session.dropped, "");
        if (c.button("Add to the scene")) session.add = std::exchange(session.dropped, "");
        if (c.button("Cancel")) session.dropped.clear();
    }
    ImGui::End();
}

}  // namespace vantage
