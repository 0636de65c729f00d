#include "player/interface/tour/told_story.h"

#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "base/text/error.h"
#include "base/text/translation.h"
#include "scene/story/story_file.h"

namespace vantage {
namespace {

constexpr double flight_seconds = 1.5;  ///< to a note

/// The text of a file; empty if there is none.
std::string text_on_disk(const std::filesystem::path& file) {
    std::ostringstream text;
    std::ifstream in(file, std::ios::binary);
    if (in && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
    return std::move(text).str();
}

}  // namespace

ToldStory told_story(const std::filesystem::path& package, const InputAxes& axes,
                     const std::string& language) {
    ToldStory told{story_file_of(package), axes, {}, language, {}, {}};
    std::error_code error;
    if (told.file.empty() || !std::filesystem::exists(std::filesystem::symlink_status(told.file, error)))
        return told;
    try {
        ReadStory read = read_story(told.file);
        told.on_disk = text_on_disk(told.file);
        told.story = std::move(read.story);
        if (!read.unknown.empty()) told.trouble = read.unknown.front();
    } catch (const Error& e) {
        told.trouble = e.what();
    }
    if (told.language.empty()) told.language = told.story.language;
    return told;
}

void open_note(ToldStory& told, Viewpoint& viewpoint, std::size_t note, double now) {
    told.playing.reset();
    told.open = note;
    const auto& view = told.story.notes[note].view;
    if (view) start_flight(viewpoint, camera_at(*view, told.axes), now, flight_seconds);
}

void play_tour(ToldStory& told, Session& s, std::size_t tour, double now) {
    try {
        const auto along = std::make_shared<const CameraSpline>(keys_of(
            told.story, told.story.tours[tour].stops, s.viewpoint.camera, told.axes, told.file.string()));
        s.viewpoint.flight = Viewpoint::Flight{{s.viewpoint.camera}, now, along->seconds(), along};
        told.playing = ToldStory::Playing{tour, now};
        told.open.reset();
    } catch (const Error& e) {
        say(s.message, e.what(), now);
    }
}

void continue_tour(ToldStory& told, const Viewpoint& viewpoint, double now) {
    if (!told.playing) return;
    if (!viewpoint.flight || !viewpoint.flight->along)
        return told.playing.reset();  // the last card stays open
    told.open.reset();
    double at = told.playing->start;
    for (const StoryStop& stop : told.story.tours[told.playing->tour].stops) {
        at += stop.fly;
        if (now >= at && now <= at + stop.stay)
            if (const StoryNote* note = note_of(told.story, stop.note))
                told.open = std::size_t(note - told.story.notes.data());
        at += stop.stay;
    }
}

std::optional<Navigation> opening_of(const ToldStory& told) {
    if (!told.story.opening) return {};
    return camera_at(*told.story.opening, told.axes);
}

void follow_language(ToldStory& told, std::string& in_use, const std::string& chosen) {
    if (chosen == in_use) return;
    in_use = chosen;
    told.language = chosen.empty() ? told.story.language : chosen;
    use_language(chosen);
}

void save(ToldStory& told) {
    if (text_on_disk(told.file) != told.on_disk)
        throw Error(Exit::usage,
                    told.file.string() + ": was changed by another program, and is not replaced");
    write_story(told.file, told.story);
    told.on_disk = story_text(told.story);
    told.changed = false;
}

}  // namespace vantage
