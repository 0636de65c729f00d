#include "player/interface/menu_bar.h"

#include <imgui.h>

#include <algorithm>

#include "base/text/translation.h"
#include "player/interface/language_menu.h"
#include "player/interface/overlays/side_views.h"
#include "player/interface/style.h"

namespace vantage {
namespace {

void view_menu(Controls& c, Session& s, const Renderer& renderer, double now) {
    const auto toggle = [&](const char* name, const char* key, bool& shown) {
        if (c.menu_item(name, key, shown)) shown = !shown;
    };
    if (c.menu_item("Home", "H")) fly_home(s, now);
    side_views_menu(c, s, renderer.package(), now);
    toggle("Orthographic", "", s.orthographic);
    c.explain("Without perspective: what is farther away looks as large.");
    ImGui::Separator();
    toggle("Photo strip", "F4", s.panels.photos);
    toggle("Cameras in the scene", "F5", s.panels.frusta);
    toggle("Radar", "F6", s.panels.radar);
    toggle("Measure", "M", s.panels.measure);
    toggle("Notes and tours", "J", s.panels.story);
    toggle("Edit the story", "Ctrl+E", s.panels.story_editor);
    ImGui::Separator();
    toggle("Picture", "F12", s.panels.picture);
    toggle("List of photos", "", s.panels.photo_list);
    toggle("Cut", "", s.panels.cut);
    toggle("Orthophoto", "", s.panels.orthophoto);
    toggle("Blending", "F2", s.panels.blending);
    toggle("Status", "F3", s.panels.status);
    if (!renderer.layers().empty()) toggle("Scalar fields", "F7", s.panels.layers);
    if (renderer.points()) toggle("Point cloud", "F8", s.panels.points);
    if (renderer.scene().image_sets.size() > 1) toggle("Image sets", "F9", s.panels.image_sets);
    toggle("Objects", "F10", s.panels.objects);
    ImGui::Separator();
    toggle("Full screen", "F11", s.full_screen);
    if (c.menu("Language")) {
        language_items(c, s);
        ImGui::EndMenu();
    }
    if (c.menu_item("Larger text", "Ctrl++"))
        s.text_scale = std::min(s.text_scale * text_step, max_text_scale);
    if (c.menu_item("Smaller text", "Ctrl+-"))
        s.text_scale = std::max(s.text_scale / text_step, least_text_scale);
}

}  // namespace

void menu_bar(Controls& c, Session& s, const Renderer& renderer, double now) {
    if (!ImGui::BeginMainMenuBar()) return;
    if (c.menu("File")) {
        if (c.menu_item("Open...", "O")) s.commands.push_back(ChooseFile{});
        if (c.menu_item("Screenshot", "P")) s.commands.push_back(SaveScreenshot{});
        if (c.menu_item("Copy view", "Ctrl+C")) s.commands.push_back(CopyView{});
        if (c.menu_item("Paste view", "Ctrl+V"))
            if (const char* text = ImGui::GetClipboardText()) s.commands.push_back(PasteView{text});
        if (c.menu_item("Quit", "Ctrl+Q")) s.commands.push_back(Quit{});
        ImGui::EndMenu();
    }
    if (c.menu("View")) {
        view_menu(c, s, renderer, now);
        ImGui::EndMenu();
    }
    if (c.menu("Path")) {
        if (c.menu_item("Record", "R", s.recording)) {
            s.recording = !s.recording;
            if (s.recording) s.recorded.clear();
        }
        if (c.menu_item("Replay", "T")) replay(s, now);
        ImGui::EndMenu();
    }
    if (c.menu("Help")) {
        if (c.menu_item("Mouse and keys", "F1", s.panels.help)) s.panels.help = !s.panels.help;
        ImGui::EndMenu();
    }
    ImGui::TextDisabled("   %s", renderer.package().path().filename().c_str());
    if (s.recording) ImGui::TextColored(ImVec4(1, 0.4f, 0.35f, 1), "   %s", tr("recording"));
    ImGui::EndMainMenuBar();
}

}  // namespace vantage
