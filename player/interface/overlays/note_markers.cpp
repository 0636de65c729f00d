#include "player/interface/overlays/note_markers.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vantage {
namespace {

void draw_marker(const NoteMarker& m, const std::string& title, bool open, bool hovered) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 at(float(m.at.x()), float(m.at.y()));
    const float radius = 0.65f * ImGui::GetFontSize();
    const int alpha = m.hidden ? 90 : 255;
    const bool bright = open || hovered;
    list.AddCircleFilled(at, radius + 1.5f, IM_COL32(0, 0, 0, alpha / 2));
    list.AddCircleFilled(at, radius, bright ? IM_COL32(255, 205, 90, alpha) : IM_COL32(245, 245, 245, alpha));
    const std::string number = std::to_string(m.note + 1);
    const ImVec2 size = ImGui::CalcTextSize(number.c_str());
    list.AddText(ImVec2(at.x - size.x / 2, at.y - size.y / 2), IM_COL32(20, 24, 30, alpha), number.c_str());
    if ((m.hidden && !bright) || title.empty()) return;
    const ImVec2 words = ImGui::CalcTextSize(title.c_str());
    const ImVec2 low(at.x + radius + 5, at.y - words.y / 2 - 3);
    list.AddRectFilled(low, ImVec2(low.x + words.x + 12, low.y + words.y + 6), IM_COL32(16, 19, 24, 190), 4);
    list.AddText(ImVec2(low.x + 6, low.y + 3), IM_COL32(245, 245, 245, 255), title.c_str());
}

}  // namespace

std::vector<NoteMarker> note_markers(const Story& story, const InputAxes& axes, const View& view,
                                     const SurfaceAt& surface) {
    constexpr double nearer = 0.01;
    const Intrinsics& k = view.intrinsics;
    std::vector<NoteMarker> out;
    for (std::size_t i = 0; i < story.notes.size(); ++i) {
        if (!story.notes[i].anchor) continue;
        const auto shown = project(k, view.cam_from_origin, *story.notes[i].anchor - axes.origin);
        if (!shown || !in_frame(k, shown->pixel)) continue;
        const auto front = surface(shown->pixel);
        const double behind = front ? depth_in(view, *front) - shown->z : HUGE_VAL,
                     same = nearer * scale_at(view, shown->z);
        if (std::abs(behind) > same && hides(story, *story.notes[i].anchor)) continue;
        out.push_back({i, shown->pixel, shown->z, behind < -same});
    }
    std::ranges::stable_sort(out, std::ranges::greater(), &NoteMarker::depth);
    return out;
}

MarkerInput draw_note_markers(Controls& controls, const std::vector<NoteMarker>& markers, const Story& story,
                              const std::string& language, std::optional<std::size_t> open) {
    MarkerInput input;
    const ImGuiIO& io = ImGui::GetIO();
    const bool dragged = io.MouseDragMaxDistanceSqr[0] > io.MouseDragThreshold * io.MouseDragThreshold;
    const float side = 1.6f * ImGui::GetFontSize();
    for (const NoteMarker& m : markers) {
        // A window of the marker's size catches the click before the camera controls do.
        const std::string name = "Note " + std::to_string(m.note + 1);
        ImGui::SetNextWindowPos(ImVec2(float(m.at.x()) - side / 2, float(m.at.y()) - side / 2));
        ImGui::SetNextWindowSize(ImVec2(side, side));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
        ImGui::Begin(("##" + name).c_str(), nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
        if (ImGui::InvisibleButton(name.c_str(), ImVec2(side, side)) && !dragged) input.clicked = m.note;
        if (ImGui::IsItemActive() && dragged) input.dragged = m.note;
        controls.note(name.c_str());
        const bool hovered = ImGui::IsItemHovered();
        ImGui::End();
        ImGui::PopStyleVar(2);
        draw_marker(m, text_in(story, story.notes[m.note].title, language), open == m.note, hovered);
    }
    return input;
}

}  // namespace vantage
