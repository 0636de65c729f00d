#include "scene/story/story.h"

#include <algorithm>
#include <set>

namespace vantage {
namespace {

const std::string* in_exactly(const Story& story, const StoryText& text, const std::string& language) {
    const auto found = text.by_language.find(language);
    if (found != text.by_language.end()) return &found->second;
    return text.by_language.empty() && language == story.language ? &text.plain : nullptr;
}

void add_languages(const StoryText& text, std::set<std::string>& out) {
    for (const auto& [language, words] : text.by_language) out.insert(language);
}

bool is_called(const StoryTour& tour, const std::string& name) {
    return tour.title.plain == name ||
           std::ranges::any_of(tour.title.by_language, [&](const auto& t) { return t.second == name; });
}

}  // namespace

const std::string& text_in(const Story& story, const StoryText& text, const std::string& language) {
    for (const std::string& l : {language, language.substr(0, language.find('-')), story.language})
        if (const std::string* found = in_exactly(story, text, l)) return *found;
    return text.by_language.empty() ? text.plain : text.by_language.begin()->second;
}

std::vector<std::string> languages_of(const Story& story) {
    std::set<std::string> out{story.language};
    add_languages(story.title, out);
    for (const StoryNote& note : story.notes) {
        add_languages(note.title, out);
        add_languages(note.text, out);
    }
    for (const StoryTour& tour : story.tours) add_languages(tour.title, out);
    return {out.begin(), out.end()};
}

const StoryNote* note_of(const Story& story, const std::string& id) {
    const auto found = std::ranges::find(story.notes, id, &StoryNote::id);
    return found == story.notes.end() ? nullptr : &*found;
}

const StoryTour* tour_of(const Story& story, const std::string& name) {
    auto found = std::ranges::find(story.tours, name, &StoryTour::id);
    if (found == story.tours.end())
        found = std::ranges::find_if(story.tours, [&](const StoryTour& t) { return is_called(t, name); });
    return found == story.tours.end() ? nullptr : &*found;
}

const StoryView* view_of_stop(const Story& story, const StoryStop& stop) {
    if (stop.view) return &*stop.view;
    const StoryNote* note = note_of(story, stop.note);
    return note && note->view ? &*note->view : nullptr;
}

bool hides(const Story& story, const Eigen::Vector3d& place) {
    return std::ranges::any_of(story.hidden, [&](const StoryBall& ball) {
        return (place - ball.center).squaredNorm() <= ball.radius * ball.radius;
    });
}

void set_text(const Story& story, StoryText& text, const std::string& language, const std::string& words) {
    if (text.by_language.empty() && (language.empty() || language == story.language)) {
        text.plain = words;
        return;
    }
    if (text.by_language.empty() && !text.plain.empty()) text.by_language[story.language] = text.plain;
    text.plain.clear();
    text.by_language[language.empty() ? story.language : language] = words;
}

void remove_note(Story& story, std::size_t note) {
    const std::string id = story.notes[note].id;
    const auto drop = [&](std::vector<StoryStop>& stops) {
        std::erase_if(stops, [&](const StoryStop& s) { return !s.view && s.note == id; });
        return stops.empty();
    };
    story.notes.erase(story.notes.begin() + std::ptrdiff_t(note));
    std::erase_if(story.tours, [&](StoryTour& t) { return drop(t.stops); });
    if (!story.attract || story.attract->turn > 0) return;
    const std::string& tour = story.attract->tour;
    const bool lost =
        tour.empty() ? drop(story.attract->stops) : !std::ranges::count(story.tours, tour, &StoryTour::id);
    if (lost) story.attract.reset();
}

std::string free_note_id(const Story& story) {
    for (std::size_t n = 1;; ++n) {
        std::string id = "note-" + std::to_string(n);
        if (!note_of(story, id)) return id;
    }
}

}  // namespace vantage
