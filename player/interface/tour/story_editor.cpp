#include "player/interface/tour/story_editor.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

/// The language that is shown, if the story has it, or else its own.
std::string edited_language(const ToldStory& told) {
    const std::vector<std::string> languages = languages_of(told.story);
    return std::ranges::count(languages, told.language) ? told.language : told.story.language;
}

/// A tour of all notes that have a view, in their order.
void make_tour(Story& story) {
    auto tour = std::ranges::find(story.tours, "all", &StoryTour::id);
    if (tour == story.tours.end()) tour = story.tours.insert(tour, {"all", {"All notes", {}}, {}});
    tour->stops.clear();
    for (const StoryNote& note : story.notes)
        if (note.view) tour->stops.push_back({note.id, {}});
    if (tour->stops.empty()) story.tours.erase(tour);
}

}  // namespace

void StoryEditor::add(ToldStory& told, const Session& s, const View& view, const SurfaceAt& surface) {
    StoryNote note{free_note_id(told.story), {}, {}};
    note.view = story_view(s.viewpoint.camera, told.axes);
    if (const auto at = surface({view.intrinsics.cx, view.intrinsics.cy}))
        note.anchor = rounded_place(*at + told.axes.origin,
                                    (s.viewpoint.camera.target - s.viewpoint.camera.eye).norm());
    told.story.notes.push_back(std::move(note));
    told.open = told.story.notes.size() - 1;
    told.changed = true;
}

/// The texts of the open note become those of the fields.
void StoryEditor::take(const ToldStory& told) {
    const std::string language = edited_language(told);
    if (edited_ == told.open && language_ == language) return;
    edited_ = told.open;
    language_ = language;
    if (!edited_) return;
    const StoryNote& note = told.story.notes[*edited_];
    const auto copy = [](auto& field, const std::string& words) {
        std::snprintf(field.data(), field.size(), "%s", words.c_str());
    };
    copy(title_, text_in(told.story, note.title, language));
    copy(text_, text_in(told.story, note.text, language));
    copy(picture_, note.picture);
}

void StoryEditor::fields(Controls& c, ToldStory& told) {
    StoryNote& note = told.story.notes[*edited_];
    ImGui::PushID(int(*edited_));
    ImGui::SetNextItemWidth(300);
    if (ImGui::InputTextWithHint("##title", tr("Title"), title_.data(), title_.size())) {
        set_text(told.story, note.title, language_, title_.data());
        told.changed = true;
    }
    c.note("Title of the note");
    if (ImGui::InputTextMultiline("##text", text_.data(), text_.size(), ImVec2(300, 120))) {
        set_text(told.story, note.text, language_, text_.data());
        told.changed = true;
    }
    c.note("Text of the note");
    ImGui::SetNextItemWidth(300);
    if (ImGui::InputTextWithHint("##picture", tr("Picture file, beside the story"), picture_.data(),
                                 picture_.size())) {
        note.picture = picture_.data();
        told.changed = true;
    }
    c.note("Picture file of the note");
    ImGui::PopID();
}

void StoryEditor::buttons(Controls& c, ToldStory& told, const Session& s) {
    auto& notes = told.story.notes;
    const std::size_t at = *edited_;
    const auto swap_with = [&](std::size_t other) {
        std::swap(notes[at], notes[other]);
        told.open = other;
        told.changed = true;
    };
    if (c.button("Set its view")) {
        notes[at].view = story_view(s.viewpoint.camera, told.axes);
        told.changed = true;
    }
    c.explain("This is where it is looked at from.");
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
        remove_note(told.story, at);
        told.open.reset();
        told.playing.reset();
        told.changed = true;
    }
}

void StoryEditor::show(Controls& c, ToldStory& told, Session& s, const View& view, const SurfaceAt& surface,
                       double now) {
    ImGui::SetNextWindowPos(ImVec2(float(s.window.free.left + s.window.free.width) - 12,
                                   float(s.window.free.top + s.window.free.height) - 12),
                            ImGuiCond_Always, ImVec2(1, 1));
    if (!ImGui::Begin(shown_name("Edit the story").c_str(), &s.window.panels.story_editor,
                      ImGuiWindowFlags_AlwaysAutoResize))
        return ImGui::End();
    const bool fixed = told.file.empty() || !told.trouble.empty();
    if (fixed)
        ImGui::TextWrapped("%s", told.file.empty() ? tr("A package on a server cannot get a story here.")
                                                   : told.trouble.c_str());
    ImGui::BeginDisabled(fixed);
    if (c.button("Add a note here")) add(told, s, view, surface);
    c.explain("Where the middle of the view meets the surface, with this view.");
    ImGui::SameLine();
    if (c.button("Set the opening view")) {
        told.story.opening = story_view(s.viewpoint.camera, told.axes);
        told.changed = true;
    }
    take(told);
    if (edited_) {
        fields(c, told);
        buttons(c, told, s);
    }
    ImGui::BeginDisabled(told.story.notes.empty());
    if (c.button("Make a tour of all notes")) {
        make_tour(told.story);
        told.playing.reset();
        told.changed = true;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!told.changed);
    if (c.button("Save the story")) try {
            save(told);
            say(s.message, formatted(tr("written to %s"), told.file.c_str()), now);
        } catch (const Error& e) {
            say(s.message, e.what(), now);
        }
    ImGui::EndDisabled();
    ImGui::EndDisabled();
    ImGui::End();
}

}  // namespace vantage
