#include "player/interface/tour/story_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/docked.h"
#include "player/interface/language_menu.h"
#include "player/interface/state/failure_text.h"

namespace vantage {
namespace {

void language_choice(Controls& c, const ActiveStory& active, Session& s) {
    const std::vector<std::string> languages = languages_of(active.story);
    if (languages.size() < 2) return;
    std::vector<std::string> own_names;
    int chosen = 0;
    for (const std::string& l : languages) {
        if (l == active.language ||
            (l == active.story.language && !std::ranges::count(languages, active.language)))
            chosen = int(own_names.size());
        own_names.push_back(own_name(l));
    }
    std::vector<const char*> names;
    for (const std::string& name : own_names) names.push_back(name.c_str());
    if (c.combo("Language", &chosen, names.data(), int(names.size())))
        s.window.language = languages[std::size_t(chosen)];
}

void tour_buttons(Controls& c, ActiveStory& active, Session& s, double now) {
    for (std::size_t i = 0; i < active.story.tours.size(); ++i) {
        const StoryTour& tour = active.story.tours[i];
        const std::string& title = text_in(active.story, tour.title, active.language);
        const std::string name = title.empty() ? tour.id : title;
        const bool plays = active.playing && active.playing->tour == i;
        ImGui::PushID(int(i));
        const std::string recorded = (plays ? "Stop " : "Play ") + name;
        if (c.button(
                (formatted(plays ? tr("Stop %s") : tr("Play %s"), name.c_str()) + "##" + recorded).c_str())) {
            if (plays)
                s.viewpoint.flight.reset();
            else
                play_tour(active, s, i, now);
        }
        ImGui::PopID();
    }
}

}  // namespace

std::string note_label(const ActiveStory& active, std::size_t note) {
    const StoryNote& n = active.story.notes[note];
    const std::string& title = text_in(active.story, n.title, active.language);
    return std::to_string(note + 1) + "  " + (title.empty() ? tr("Untitled note") : title);
}

void story_content(Controls& c, ActiveStory& active, Session& s, double now) {
    if (!s.window.kiosk) language_choice(c, active, s);  // a kiosk's bar has the choice
    for (std::size_t i = 0; i < active.story.notes.size(); ++i) {
        ImGui::PushID(int(i));
        if (ImGui::Selectable(note_label(active, i).c_str(), active.open == i))
            open_note(active, s.viewpoint, i, now);
        c.note(("List " + std::to_string(i + 1)).c_str());
        ImGui::PopID();
    }
    tour_buttons(c, active, s, now);
    if (!active.trouble.empty() && !s.window.kiosk) ImGui::TextWrapped("%s", active.trouble.c_str());
}

void note_content(Controls& c, ActiveStory& active, NotePicture& picture, Session& s, ImVec2 room,
                  double now) {
    const std::size_t at = *active.open, count = active.story.notes.size();
    const StoryNote& note = active.story.notes[at];
    picture.load(note.picture.empty() ? std::filesystem::path() : active.file.parent_path() / note.picture);
    if (picture.texture()) {
        const float scale =
            std::min(1.0f, std::min(room.x / float(picture.width()), room.y / float(picture.height())));
        ImGui::Image(ImTextureID(std::uintptr_t(picture.texture())),
                     ImVec2(scale * float(picture.width()), scale * float(picture.height())));
        c.note("Picture of the note");
    } else if (!picture.trouble().empty() && !s.window.kiosk) {
        ImGui::TextWrapped("%s", failure_text(tr("The picture cannot be shown."), picture.trouble()).c_str());
    }
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room.x);
    ImGui::TextUnformatted(text_in(active.story, note.text, active.language).c_str());
    ImGui::PopTextWrapPos();
    if (count > 1 && c.button("Previous note")) open_note(active, s.viewpoint, (at + count - 1) % count, now);
    if (count > 1) ImGui::SameLine();
    if (count > 1 && c.button("Next note")) open_note(active, s.viewpoint, (at + 1) % count, now);
}

void story_panel(Controls& c, ActiveStory& active, Session& s, double room, double now) {
    const float em = ImGui::GetFontSize(), width = float(s.window.free.width) - 24,
                height = std::min(0.6f * float(s.window.free.height), float(room) - 24);
    ImGui::SetNextWindowPos(
        ImVec2(float(s.window.free.left + s.window.free.width) - 12, float(s.window.free.top) + 12),
        ImGuiCond_Appearing, ImVec2(1, 0));
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(std::min(16 * em, width), 4 * em),
        ImVec2(std::min(23 * em, width), std::max(least_story_panel * em, height)));
    const std::string& title = text_in(active.story, active.story.title, active.language);
    if (!ImGui::Begin(((title.empty() ? tr("Story") : title) + "###story").c_str(),
                      s.window.kiosk ? nullptr : &s.window.panels.story, reading_panel(s.window)))
        return ImGui::End();
    keep_within(s.window.free);
    const float space = s.window.kiosk ? 0.8f * em : ImGui::GetStyle().ItemSpacing.y;  // for touch
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, space));
    story_content(c, active, s, now);
    ImGui::PopStyleVar();
    ImGui::End();
}

void note_card(Controls& c, ActiveStory& active, NotePicture& picture, Session& s, double now) {
    if (!active.open || *active.open >= active.story.notes.size()) return;
    const float em = ImGui::GetFontSize(), high = float(s.window.free.height),
                width = std::min(27 * em, float(s.window.free.width) - 24);
    ImGui::SetNextWindowPos(ImVec2(float(s.window.free.left) + 12, float(s.window.free.top) + 12),
                            ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 6 * em), ImVec2(width, std::max(8 * em, 0.9f * high)));
    bool shown = true;
    if (ImGui::Begin((note_label(active, *active.open) + "###card").c_str(), &shown,
                     reading_panel(s.window))) {
        keep_within(s.window.free);
        note_content(c, active, picture, s,
                     ImVec2(width - 2 * ImGui::GetStyle().WindowPadding.x, 0.4f * high), now);
    }
    ImGui::End();
    if (!shown) active.open.reset();
}

}  // namespace vantage
