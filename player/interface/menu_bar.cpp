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
    if (leveled(s.viewpoint.camera) && c.menu_item("Level", "L")) fly_level(s, now);
    if (c.menu_item("Auto-rotate", "U", rotates(s.viewpoint)))
        toggle_rotation(s, renderer.package().photos(), now);
    c.explain(
        "Turns the view slowly about its middle, where there are photos, until you click on the picture, use "
        "the wheel or press a key.");
    toggle("Orthographic", "", s.viewpoint.orthographic);
    c.explain("Without perspective: equal lengths appear equal at any distance.");
    ImGui::Separator();
    toggle("Photo strip", "F4", s.window.panels.photos);
    toggle("Cameras in the scene", "F5", s.window.panels.frusta);
    toggle("Radar", "F6", s.window.panels.radar);
    toggle("Measure", "M", s.window.panels.measure);
    toggle("Notes and tours", "J", s.window.panels.story);
    toggle("Edit the story", marked("Ctrl+E"), s.window.panels.story_editor);
    ImGui::Separator();
    toggle("Full screen", "F11", s.window.full_screen);
    if (c.menu("Language")) {
        language_items(c, s.window);
        ImGui::EndMenu();
    }
    if (c.menu_item("Larger text", marked("Ctrl++")))
        s.window.text_scale = std::min(s.window.text_scale * text_step, max_text_scale);
    if (c.menu_item("Smaller text", marked("Ctrl+-")))
        s.window.text_scale = std::max(s.window.text_scale / text_step, least_text_scale);
}

}  // namespace

void menu_bar(Controls& c, Session& s, const Renderer& renderer, double now) {
    if (!ImGui::BeginMainMenuBar()) return;
    if (c.menu("File")) {
        if (c.menu_item("Open...", "O")) s.window.commands.push_back(ChooseFile{});
        if (c.menu_item("Screenshot", "P")) s.window.commands.push_back(SaveScreenshot{});
        if (c.menu_item("Copy view", marked("Ctrl+C"))) s.window.commands.push_back(CopyView{});
        if (c.menu_item("Paste view", marked("Ctrl+V")))
            if (const char* text = ImGui::GetClipboardText()) s.window.commands.push_back(PasteView{text});
        if (c.menu_item("Quit", marked("Ctrl+Q"))) s.window.commands.push_back(Quit{});
        ImGui::EndMenu();
    }
    if (c.menu("Edit")) {
        if (c.menu_item("Undo", marked("Ctrl+Z"))) s.window.commands.push_back(Undo{});
        if (c.menu_item("Redo", marked("Ctrl+Shift+Z"))) s.window.commands.push_back(Redo{});
        ImGui::EndMenu();
    }
    if (c.menu("View")) {
        view_menu(c, s, renderer, now);
        ImGui::EndMenu();
    }
    if (c.menu("Path")) {
        if (c.menu_item("Record", "R", s.path.recording)) toggle_recording(s.path);
        if (c.menu_item("Replay", "T")) replay(s.viewpoint, s.path, now);
        ImGui::EndMenu();
    }
    if (c.menu("Help")) {
        if (c.menu_item("Mouse and keys", "F1", s.window.panels.help))
            s.window.panels.help = !s.window.panels.help;
        ImGui::EndMenu();
    }
    ImGui::TextDisabled("   %s", renderer.package().path().filename().c_str());
    if (s.path.recording) ImGui::TextColored(ImVec4(1, 0.4f, 0.35f, 1), "   %s", tr("recording"));
    ImGui::EndMainMenuBar();
}

}  // namespace vantage
