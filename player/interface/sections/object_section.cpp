#include "player/interface/sections/object_section.h"

#include <imgui.h>

#include <filesystem>
#include <string>

#include "base/text/translation.h"

namespace vantage {
namespace {

/// "Only##Only NAME"
std::string of(const SceneObject& object, const std::string& label, const std::string& recorded) {
    return label + "##" + recorded + " " + object.name;
}

/// Sliders for an object's placement.
bool placement_sliders(Controls& c, ObjectSet& objects, std::size_t object, double size) {
    const SceneObject& o = objects.at(object);
    Placement p = o.placement;
    bool changed = false;
    constexpr const char* axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string move = std::string("Move ") + axes[axis];
        changed |=
            c.slider(of(o, std::string(tr_in("object", "Move")) + " " + axes[axis], move + " of").c_str(),
                     &p.move[axis], -2 * size, 2 * size, "%.3f");
    }
    for (int axis = 0; axis < 3; ++axis) {
        const std::string turn = std::string("Turn ") + axes[axis];
        changed |=
            c.slider(of(o, std::string(tr_in("object", "Turn")) + " " + axes[axis], turn + " of").c_str(),
                     &p.turn[axis], -180, 180, "%.1f°");
    }
    changed |= c.slider(of(o, tr_in("object", "Scale"), "Scale of").c_str(), &p.scale, 0.01, 100, "%.3f",
                        ImGuiSliderFlags_Logarithmic);
    if (changed) objects.place(object, p);
    return changed;
}

bool opacity_slider(Controls& c, ObjectSet& objects, std::size_t object) {
    const SceneObject& o = objects.at(object);
    double opacity = o.opacity;
    if (!c.slider(of(o, tr("Opacity"), "Opacity of").c_str(), &opacity, 0, 1, "%.2f")) return false;
    objects.set_opacity(object, opacity);
    return true;
}

/// The settings of one object. Sets `removed` if the object is to be removed.
bool object_row(Controls& c, ObjectSet& objects, std::size_t object, double size, bool& removed) {
    const SceneObject& o = objects.at(object);
    bool changed = false;
    bool* open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID(of(o, "open", "open").c_str()));
    if (c.button(of(o, tr("Only this"), "Only").c_str())) objects.show_only(object), changed = true;
    if (object > 0) {
        ImGui::SameLine();
        if (c.button(of(o, tr("Place"), "Position of").c_str())) *open = !*open;
        ImGui::SameLine();
        removed = c.button(of(o, tr("Remove"), "Remove").c_str());
    }
    changed |= opacity_slider(c, objects, object);
    if (object > 0 && *open) changed |= placement_sliders(c, objects, object, size);
    return changed;
}

}  // namespace

bool object_section(Controls& c, UserCommands& commands, ObjectSet& objects, double size, bool more) {
    bool changed = false;
    std::size_t remove = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        bool shown = objects.at(i).shown, removed = false;
        if (c.checkbox(objects.at(i).name.c_str(), &shown)) objects.show_object(i, shown), changed = true;
        if (more) changed |= object_row(c, objects, i, size, removed);
        if (removed) remove = i;
    }
    if (!more) return changed;
    if (c.button("Save scene")) commands.push_back(SaveScene{});
    c.explain("Writes a scene file with these packages and their placement.");
    if (remove > 0) objects.remove(remove), changed = true;
    return changed;
}

void drop_dialog(Controls& c, UserCommands& commands, std::string& file) {
    if (file.empty()) {
        const auto dropped = take<PlaceDropped>(commands);
        if (!dropped) return;
        file = dropped->file;
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    if (ImGui::Begin(shown_name("Dropped package").c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::TextUnformatted(std::filesystem::path(file).filename().c_str());
        const bool opens = c.button("Open in place of the scene"), adds = c.button("Add to the scene"),
                   cancels = c.button("Cancel");
        if (opens) commands.push_back(OpenFile{file});
        if (adds) commands.push_back(AddObject{file});
        if (opens || adds || cancels) file.clear();
    }
    ImGui::End();
}

}  // namespace vantage
