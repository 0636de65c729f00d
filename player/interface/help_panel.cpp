#include "player/interface/help_panel.h"

#include <imgui.h>

#include <string>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/render/passes/blend_table.h"

namespace vantage {
namespace {

/// The keys and labels of the blending modes: "1 2 3" and "Lumigraph, Average, Best photo".
Shortcut blend_shortcuts() {
    Shortcut out;
    int key = 1;
    for (const BlendRow& row : blend_table()) {
        out.keys += (key > 1 ? " " : "") + std::to_string(key);
        out.action += std::string(key > 1 ? ", " : "") + tr(row.label);
        ++key;
    }
    return out;
}

/// The help in a kiosk, whose visitors have neither mouse nor keyboard.
std::vector<Shortcut> touch_gestures() {
    return {{marked("one finger"), marked("orbit the model")},
            {marked("two fingers"), marked("pan, move closer or away, turn")},
            {marked("two taps"), marked("move closer to the tapped point")}};
}

void show_line(const Shortcut& line) {
    ImGui::TextColored(ImVec4(0.55f, 0.75f, 1, 1), "%s", tr(line.keys.c_str()));
    ImGui::SameLine(16 * ImGui::GetFontSize());
    ImGui::TextUnformatted(tr(line.action.c_str()));
}

}  // namespace

std::vector<Shortcut> shortcuts() {
    const Shortcut blends = blend_shortcuts();
    return {{marked("drag, or one finger"), marked("orbit the model"), true},
            {marked("drag, right or middle button"), marked("pan"), true},
            {marked("Ctrl and drag"), marked("look around")},
            {marked("Shift and drag"), marked("move the raking light, like dragging its lamp"), true},
            {marked("wheel"), marked("zoom to or from the point under the pointer"), true},
            {marked("double click, or two taps"), marked("move closer to the point under the pointer"), true},
            {marked("two fingers"), marked("pan, move closer or away, turn"), true},
            {marked("W A S D, Q E"), marked("fly; faster with Shift")},
            {marked("H, Backspace"), marked("back to the first view; back to the previous view"), true},
            {"N, B", marked("fly to the photo on the right, on the left"), true},
            {"C", marked("compare with the closest photo; drag the line between them"), true},
            {"V", marked("show photos, which photo, how many photos")},
            {"X", marked("show the next image set"), true},
            blends,
            {"L, U", marked("level the view; start or stop auto-rotation")},
            {"R, T", marked("record a path, replay it")},
            {"M", marked("measure")},
            {"J", marked("show or hide notes and tours")},
            {marked("Ctrl+E"), marked("edit notes and tours")},
            {"O", marked("open another package (or drop it here)")},
            {"P", marked("screenshot")},
            {marked("Ctrl+Z, Ctrl+Shift+Z"), marked("undo, redo: notes, measurements, cuts, settings")},
            {marked("Ctrl+C, Ctrl+V"), marked("copy the view as a command line, fly to a copied view")},
            {marked("arrow keys, Space or Enter"), marked("select a control, activate it"), true},
            {marked("Ctrl+Tab, Alt"), marked("go to another panel, to the menu")},
            {marked("Tab"), marked("all settings, or only the picture")},
            {marked("F1 to F12"), marked("help and panels; F11: full screen")},
            {marked("Ctrl with + or -"), marked("larger or smaller text")},
            {marked("Esc"), marked("close help, stop a flight or a comparison"), true},
            {marked("Ctrl+Q"), marked("quit")}};
}

void help_panel(Controls& c, WindowState& window) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowBgAlpha(1);
    const char* const title = marked("Mouse, fingers and keys");
    if (ImGui::Begin(shown_name(window.kiosk ? marked("Touch gestures") : title).c_str(), &window.panels.help,
                     reading_panel(window) | ImGuiWindowFlags_NoSavedSettings)) {
        for (const Shortcut& line : window.kiosk ? touch_gestures() : shortcuts()) show_line(line);
        if (!window.kiosk) {
            ImGui::Separator();
            ImGui::TextUnformatted(
                formatted(tr("Vantage %s, published under the MIT license"), VANTAGE_VERSION).c_str());
        }
        const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
        c.note(title, low, ImVec2(low.x + size.x, low.y + size.y));
    }
    ImGui::End();
}

}  // namespace vantage
