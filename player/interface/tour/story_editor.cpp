#include "player/interface/tour/story_editor.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"
#include "player/interface/tour/story_panel.h"

namespace vantage {
namespace {

constexpr float field_width = 21.5f;  ///< of text fields, in multiples of the text height

/// The displayed language if the story has it, otherwise the story's default language.
std::string edited_language(const ActiveStory& active) {
    const std::vector<std::string> languages = languages_of(active.story);
    return std::ranges::count(languages, active.language) ? active.language : active.story.language;
}

/// Whether a text field has changed, except by Esc, which ends typing but must not lose the text.
bool keeps_typed(bool changed) { return changed && !ImGui::IsItemDeactivated(); }

/// A text field of one line. Its ID and its recorded name are `name`. Returns whether the text has changed.
bool line_field(Controls& c, const std::string& name, const char* hint, std::string& text) {
    std::array<char, 501> typed{};
    std::snprintf(typed.data(), typed.size(), "%s", text.c_str());
    ImGui::SetNextItemWidth(field_width * ImGui::GetFontSize());
    const bool changed =
        keeps_typed(ImGui::InputTextWithHint(("##" + name).c_str(), hint, typed.data(), typed.size()));
    if (changed) text = typed.data();
    c.note(name.c_str());
    return changed;
}

/// A field for a title in the edited language.
void title_field(Controls& c, ActiveStory& active, const std::string& name, const char* hint,
                 StoryText& title) {
    const std::string language = edited_language(active);
    std::string words = text_in(active.story, title, language);
    if (!line_field(c, name, hint, words)) return;
    set_text(active.story, title, language, words);
    active.changed = true;
}

/// A tour of all notes with a view, in their order. Keeps its title and the durations of stops.
void make_tour(Story& story) {
    auto tour = std::ranges::find(story.tours, "all", &StoryTour::id);
    if (tour == story.tours.end()) tour = story.tours.insert(tour, {"all", {tr("All notes"), {}}, {}});
    const std::vector<StoryStop> before = std::exchange(tour->stops, {});
    for (const StoryNote& note : story.notes) {
        if (!note.view) continue;
        const auto stop = std::ranges::find(before, note.id, &StoryStop::note);
        tour->stops.push_back(stop == before.end() ? StoryStop{note.id} : *stop);
    }
    if (tour->stops.empty()) story.tours.erase(tour);
}

/// The durations of the stops at a note.
void durations(Controls& c, ActiveStory& active, const std::string& note) {
    constexpr double most = 3600;
    const auto seconds = [&](const char* name, double& value) {
        ImGui::SetNextItemWidth(4 * ImGui::GetFontSize());
        if (!c.number(name, &value, "%g")) return;
        value = std::clamp(value, 0.0, most);
        active.changed = true;
    };
    for (StoryTour& tour : active.story.tours)
        for (StoryStop& stop : tour.stops) {
            if (stop.note != note) continue;
            const std::string& title = text_in(active.story, tour.title, active.language);
            ImGui::PushID(&stop);
            ImGui::TextDisabled(tr("In the tour %s, in seconds:"),
                                title.empty() ? tour.id.c_str() : title.c_str());
            seconds(MARKED_IN("stop", "Flight"), stop.fly);
            ImGui::SameLine();
            seconds(MARKED_IN("stop", "Stay"), stop.stay);
            ImGui::PopID();
        }
}

}  // namespace

bool place_note(ActiveStory& active, std::size_t note, const Session& s, const SurfaceAt& surface,
                const Eigen::Vector2d& pixel) {
    const auto at = surface ? surface(pixel) : std::nullopt;
    if (!at) return false;
    active.story.notes[note].anchor =
        rounded_place(*at + active.axes.origin, (s.viewpoint.camera.target - s.viewpoint.camera.eye).norm());
    active.open = note;
    active.changed = true;
    return true;
}

void StoryEditor::add(ActiveStory& active, const Session& s, const SurfaceAt& surface,
                      const Eigen::Vector2d& pixel) {
    StoryNote note{free_note_id(active.story), {}, {}};
    note.view = story_view(s.viewpoint.camera, active.axes);
    active.story.notes.push_back(std::move(note));
    active.open = active.story.notes.size() - 1;
    active.changed = true;
    place_note(active, *active.open, s, surface, pixel);
}

void StoryEditor::take_click(ActiveStory& active, Session& s, const SurfaceAt& surface, double now) {
    const auto pixel = clicked_pixel(s.window.input);
    if (!s.window.places_note || !pixel) return;
    if (!surface || !surface(*pixel)) return say(s.message, tr("Only the model can be clicked"), now);
    if (moves_ && active.open)
        place_note(active, *active.open, s, surface, *pixel);
    else
        add(active, s, surface, *pixel);
    s.window.places_note = false;
}

/// Without a mouse or a surface to click, notes are placed at the center of the view.
void StoryEditor::place_buttons(Controls& c, ActiveStory& active, Session& s, const View& view,
                                const SurfaceAt& surface) {
    const Eigen::Vector2d center(view.intrinsics.cx, view.intrinsics.cy);
    const auto wait_for_click = [&](bool moves) {
        moves_ = moves;
        s.window.places_note = true;
        s.window.panels.measure = s.window.hides_pieces = false;  // they take clicks, too
    };
    const bool at_center = s.window.navigates || !surface;
    if (c.button("Add a note")) at_center ? add(active, s, surface, center) : wait_for_click(false);
    c.explain(
        "The next click on the model places the note, and stores this view. With the keyboard, the note is "
        "placed at the center of the view.");
    ImGui::SameLine();
    ImGui::BeginDisabled(!active.open);
    if (c.button("Move its mark")) {
        if (at_center)
            place_note(active, *active.open, s, surface, center);
        else
            wait_for_click(true);
    }
    ImGui::EndDisabled();
    c.explain("The next click on the model moves the note's mark there. Marks can also be dragged.");
    ImGui::SameLine();
}

/// The story also keeps whether the background is hidden.
void StoryEditor::set_opening(ActiveStory& active, Session& s, double now) const {
    active.story.opening = story_view(s.viewpoint.camera, active.axes);
    active.story.only_object = background_ && s.settings.background == ShowBackground::off;
    active.changed = true;
    s.viewpoint.home = s.viewpoint.camera;
    say(s.message,
        active.story.only_object ? tr("The story opens with this view, without the background")
                                 : tr("The story opens with this view"),
        now);
}

void StoryEditor::fields(Controls& c, ActiveStory& active) {
    StoryNote& note = active.story.notes[*active.open];
    ImGui::PushID(int(*active.open));
    title_field(c, active, "Title of the note", tr("Title"), note.title);
    const std::string language = edited_language(active);
    std::array<char, 20001> text{};
    std::snprintf(text.data(), text.size(), "%s", text_in(active.story, note.text, language).c_str());
    const float em = ImGui::GetFontSize();
    if (keeps_typed(ImGui::InputTextMultiline("##text", text.data(), text.size(),
                                              ImVec2(field_width * em, 8.5f * em)))) {
        set_text(active.story, note.text, language, text.data());
        active.changed = true;
    }
    c.note("Text of the note");
    active.changed |=
        line_field(c, "Picture file of the note", tr("Picture file, beside the story"), note.picture);
    durations(c, active, note.id);
    ImGui::PopID();
}

void StoryEditor::buttons(Controls& c, ActiveStory& active, const Session& s) {
    auto& notes = active.story.notes;
    const std::size_t at = *active.open;
    const auto swap_with = [&](std::size_t other) {
        std::swap(notes[at], notes[other]);
        active.open = other;
        active.changed = true;
    };
    if (c.button("Set its view")) {
        notes[at].view = story_view(s.viewpoint.camera, active.axes);
        active.changed = true;
    }
    c.explain("The note is viewed from here.");
    ImGui::SameLine();
    ImGui::BeginDisabled(at == 0);
    if (c.button("Move up")) swap_with(at - 1);
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(at + 1 == notes.size());
    if (c.button("Move down")) swap_with(at + 1);
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (c.button("Delete")) {
        remove_note(active.story, at);
        active.open.reset();
        active.playing.reset();
        active.changed = true;
    }
}

/// A field for each tour's title, and the buttons for the whole story.
void StoryEditor::tours(Controls& c, ActiveStory& active, Session& s, double now) const {
    for (StoryTour& tour : active.story.tours) {
        title_field(c, active, "Title of the tour " + tour.id, tr("Title of the tour"), tour.title);
        c.explain("Title of the tour");
    }
    ImGui::BeginDisabled(active.story.notes.empty());
    if (c.button("Make a tour of all notes")) {
        make_tour(active.story);
        active.playing.reset();
        active.changed = true;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!active.changed);
    if (c.button("Save the story")) save(active, s.message, now);
    ImGui::EndDisabled();
}

void StoryEditor::content(Controls& c, ActiveStory& active, Session& s, const View& view,
                          const Surfaces& surfaces, double now) {
    const bool fixed = !active.editable();
    if (fixed)
        ImGui::TextWrapped("%s", active.file.empty()
                                     ? tr("The story of a package on a server cannot be edited here.")
                                     : active.trouble.c_str());
    ImGui::BeginDisabled(fixed);
    if (!fixed) take_click(active, s, surfaces.model, now);
    title_field(c, active, "Title of the story", tr("Title of the story"), active.story.title);
    place_buttons(c, active, s, view, surfaces.model);
    if (c.button("Set the opening view")) set_opening(active, s, now);
    c.explain("The story opens with this view, and without the background if it is hidden now.");
    if (s.window.places_note) ImGui::TextDisabled("%s", tr("Click on the model; Esc cancels."));
    brush_.show(c, active, s, view, surfaces.anything, now);
    if (active.open) {
        fields(c, active);
        buttons(c, active, s);
    }
    tours(c, active, s, now);
    ImGui::EndDisabled();
}

double StoryEditor::show(Controls& c, ActiveStory& active, Session& s, const View& view,
                         const Surfaces& surfaces, double now) {
    const Area& free = s.window.free;
    const float em = ImGui::GetFontSize(), list = least_story_panel * em;
    ImGui::SetNextWindowPos(ImVec2(float(free.left + free.width) - 12, float(free.top + free.height) - 12),
                            ImGuiCond_Always, ImVec2(1, 1));
    ImGui::SetNextWindowSizeConstraints(
        ImVec2(0, 0), ImVec2(float(free.width) - 24, std::max(5 * em, float(free.height) - list - 36)));
    const bool open = ImGui::Begin(shown_name("Edit the story").c_str(), &s.window.panels.story_editor,
                                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_HorizontalScrollbar);
    const double above = double(ImGui::GetWindowPos().y) - free.top;
    if (open) content(c, active, s, view, surfaces, now);
    ImGui::End();
    return above;
}

}  // namespace vantage
