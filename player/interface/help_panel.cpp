#include "player/interface/help_panel.h"

#include <imgui.h>

#include <cctype>
#include <string>

#include "player/render/blend_table.h"

namespace vantage {
namespace {

struct Shortcuts {
    std::string keys, labels;
};

/// "1 2 3" and "lumigraph, average, best photo".
Shortcuts blend_shortcuts() {
    Shortcuts out;
    int key = 1;
    for (const BlendRow& row : blend_table()) {
        std::string label = row.label;
        label[0] = char(std::tolower(label[0]));
        out.keys += (key > 1 ? " " : "") + std::to_string(key);
        out.labels += (key > 1 ? ", " : "") + label;
        ++key;
    }
    return out;
}

/// A line of the help.
struct Line {
    const char *what, *does;
    bool for_public = false;  ///< also in a kiosk
};

void show_line(const Line& line) {
    ImGui::TextColored(ImVec4(0.55f, 0.75f, 1, 1), "%s", line.what);
    ImGui::SameLine(16 * ImGui::GetFontSize());
    ImGui::TextUnformatted(line.does);
}

}  // namespace

void help_panel(Session& s) {
    const Shortcuts blends = blend_shortcuts();
    const Line lines[] = {{"drag, or one finger", "orbit the model", true},
                          {"drag, right or middle button", "pan", true},
                          {"Ctrl and drag", "look around"},
                          {"wheel", "closer to what is under the pointer, or away", true},
                          {"double click, or two taps", "look at what is under the pointer", true},
                          {"two fingers", "pan, move closer or away, turn", true},
                          {"W A S D, Q E", "fly; faster with Shift"},
                          {"H, Backspace", "back to the first view; to the view before", true},
                          {"N, B", "fly to the photo on the right, on the left", true},
                          {"C", "compare with the closest photo; drag the line between them", true},
                          {"V", "show photos, which photo, how many photos"},
                          {"X", "show the next band of photos", true},
                          {blends.keys.c_str(), blends.labels.c_str()},
                          {"R, T", "record a path, replay it"},
                          {"M", "measure"},
                          {"J", "show or hide notes and tours"},
                          {"Ctrl+E", "edit notes and tours"},
                          {"O", "open another package (or drop it here)"},
                          {"P", "screenshot"},
                          {"Ctrl+C, Ctrl+V", "copy the view as a command line, fly to a copied one"},
                          {"Tab", "all settings, or only the picture"},
                          {"F1 to F12", "help and panels; F11: full screen"},
                          {"Ctrl with + or -", "larger or smaller text"},
                          {"Esc", "close help, stop a flight or a comparison", true},
                          {"Ctrl+Q", "quit"}};
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowBgAlpha(1);
    if (ImGui::Begin("Mouse, fingers and keys", &s.panels.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings))
        for (const Line& line : lines)
            if (line.for_public || !s.kiosk) show_line(line);
    ImGui::End();
}

}  // namespace vantage
