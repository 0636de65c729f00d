#include "player/interface/undo.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <utility>

#include "base/text/formatted.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

/// Copies the settings that are not undone: they follow the frame or a comparison.
void copy_transient(const SessionSettings& from, SessionSettings& to) {
    const RenderSettings& now = from.settings;
    RenderSettings& r = to.settings;
    r.compare = now.compare;
    r.compare_photo = now.compare_photo;
    if (r.exposure && now.exposure) r.exposure = now.exposure;
    r.swipe = now.swipe;
    r.image_sets.how = now.image_sets.how;
    r.image_sets.swipe = now.image_sets.swipe;
    r.points.pick = now.points.pick;
    r.sections = now.sections;
    r.capacity = now.capacity;
}

/// The open note stays open if it still exists.
void restore(ActiveStory& active, const Story& story) {
    const std::string open = active.open ? active.story.notes[*active.open].id : "";
    active.story = story;
    active.open.reset();
    if (const StoryNote* const note = note_of(active.story, open))
        active.open = std::size_t(note - active.story.notes.data());
    active.playing.reset();
    active.changed = story != active.saved;
}

}  // namespace

template <class T>
void UndoHistory::record(T& last, const T& now, bool is_change) {
    if (last == now) return;
    if (is_change) {
        steps_.resize(done_);
        if (steps_.size() == most_steps) steps_.erase(steps_.begin());
        steps_.push_back(Step<T>{last, now});
        done_ = steps_.size();
    }
    last = now;
}

void UndoHistory::record(const Session& s, const ActiveStory& active, const MeasurePanel& measure) {
    const bool settled = settling_ == 0, read = std::exchange(reads_, measure.reads()) != measure.reads();
    if (!settled) --settling_;
    record(story_, active.story, settled);
    record(survey_, measure.survey(), settled && !read);
    copy_transient(s, settings_);
    record<SessionSettings>(settings_, s, settled);
}

void UndoHistory::move(Session& s, ActiveStory& active, MeasurePanel& measure, bool back, double now) {
    if (back && measure.unfinished()) return measure.remove_last_point();
    if (done_ == (back ? 0 : steps_.size()))
        return say(s.message, back ? tr("Nothing to undo") : tr("Nothing to redo"), now);
    const auto& step = steps_[back ? --done_ : done_++];
    const char* what = "";
    if (const auto* const story = std::get_if<Step<Story>>(&step)) {
        what = tr_in("undo", "story");
        restore(active, back ? story->before : story->after);
    } else if (const auto* const survey = std::get_if<Step<Survey>>(&step)) {
        what = tr_in("undo", "measurements");
        measure.restore(s, back ? survey->after : survey->before, back ? survey->before : survey->after, now);
    } else if (const auto* const settings = std::get_if<Step<SessionSettings>>(&step)) {
        what = settings->before.cut == settings->after.cut ? tr_in("undo", "settings") : tr_in("undo", "cut");
        SessionSettings to = back ? settings->before : settings->after;
        copy_transient(s, to);
        static_cast<SessionSettings&>(s) = std::move(to);
    }
    say(s.message, formatted(back ? tr("Undone: %s") : tr("Redone: %s"), what), now);
    settling_ = 3;
}

void UndoHistory::attend(Session& s, ActiveStory& active, MeasurePanel& measure, double now) {
    const bool held = ImGui::IsAnyMouseDown(), in_use = held || ImGui::IsAnyItemActive(),
               pressed = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    // A control may change something in the frame in which it is clicked, but not when a key selects it.
    const unsigned last = std::exchange(control_, ImGui::GetActiveID());
    if (!in_use || pressed || (control_ != last && !held)) record(s, active, measure);
    while (const auto command = take_one_of<Undo, Redo>(s.window.commands))
        if (!in_use) move(s, active, measure, std::holds_alternative<Undo>(*command), now);
}

}  // namespace vantage
