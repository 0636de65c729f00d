#include "player/interface/tour/active_story.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"
#include "player/tour/tour_stop.h"
#include "scene/story/story_file.h"

namespace vantage {
namespace {

constexpr double flight_seconds = 1.5;  ///< duration of a flight to a note

/// The text of a file; empty if there is none.
std::string text_on_disk(const std::filesystem::path& file) {
    std::ostringstream text;
    std::ifstream in(file, std::ios::binary);
    if (in && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
    return std::move(text).str();
}

}  // namespace

ActiveStory active_story(const std::filesystem::path& package, const InputAxes& axes,
                         const std::string& language) {
    ActiveStory active{story_file_of(package), axes, {}, language, {}, {}};
    const std::string base = language.substr(0, language.find('-'));
    if (std::ranges::count(languages_of_window(), base)) active.story.language = base;
    active.saved = active.story;
    std::error_code error;
    if (active.file.empty() || !std::filesystem::exists(std::filesystem::symlink_status(active.file, error)))
        return active;
    try {
        ReadStory read = read_story(active.file);
        active.on_disk = text_on_disk(active.file);
        active.story = std::move(read.story);
        active.saved = active.story;
        if (!read.unknown.empty())
            active.trouble = failure_text(tr("The story cannot be edited."), read.unknown.front());
    } catch (const Error& e) {
        active.trouble = failure_text(tr("The story cannot be read."), e);
    }
    if (active.language.empty()) active.language = active.story.language;
    return active;
}

void open_note(ActiveStory& active, Viewpoint& viewpoint, std::size_t note, double now) {
    active.playing.reset();
    active.open = note;
    const auto& view = active.story.notes[note].view;
    if (view) start_flight(viewpoint, camera_at(*view, active.axes), now, flight_seconds);
}

void play_tour(ActiveStory& active, Session& s, std::size_t tour, double now) {
    try {
        const auto along = std::make_shared<const CameraSpline>(
            keys_of(active.story, active.story.tours[tour].stops, s.viewpoint.camera, active.axes,
                    active.file.string()));
        s.viewpoint.flight = Viewpoint::Flight{{s.viewpoint.camera}, now, along->seconds(), along};
        active.playing = ActiveStory::Playing{tour, now};
        active.open.reset();
    } catch (const Error& e) {
        say(s.message, failure_text(tr("The tour cannot be played."), e), now);
    }
}

void continue_tour(ActiveStory& active, const Viewpoint& viewpoint, double now) {
    if (!active.playing) return;
    if (!viewpoint.flight || !viewpoint.flight->along)
        return active.playing.reset();  // the last card stays open
    active.open =
        note_at_stop(active.story, active.story.tours[active.playing->tour], now - viewpoint.flight->start);
}

std::optional<std::size_t> note_at_stop(const Story& story, const StoryTour& tour, double seconds) {
    if (tour.stops.empty()) return {};
    const TourStop at = tour_stop(tour, seconds);
    const StoryNote* const note = note_of(story, tour.stops[at.stop].note);
    constexpr double rounding = 1e-6;  // seconds, of a flight that waits upon its arrival
    if (!note || seconds < at.reached - rounding) return {};
    return std::size_t(note - story.notes.data());
}

std::optional<Navigation> opening_of(const ActiveStory& active) {
    if (!active.story.opening) return {};
    return camera_at(*active.story.opening, active.axes);
}

void follow_language(ActiveStory& active, std::string& in_use, const std::string& chosen) {
    if (chosen == in_use) return;
    in_use = chosen;
    active.language = chosen.empty() ? active.story.language : chosen;
    use_language(active.language);
}

void save(ActiveStory& active) {
    if (text_on_disk(active.file) != active.on_disk)
        throw Error(Exit::usage,
                    active.file.string() + ": was changed by another program, and is not replaced");
    write_story(active.file, active.story);
    active.on_disk = story_text(active.story);
    active.saved = active.story;
    active.changed = false;
}

bool save(ActiveStory& active, Message& message, double now) {
    try {
        save(active);
        say(message, formatted(tr("written to %s"), active.file.c_str()), now, active.file);
    } catch (const Error& e) {
        say(message, failure_text(tr("The story is not saved."), e), now);
    }
    return !active.changed;
}

}  // namespace vantage
