#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/interface/state/session.h"
#include "player/tour/story_views.h"
#include "scene/story/story.h"

namespace vantage {

/// The story of the shown scene, and its playback state.
struct ActiveStory {
    std::filesystem::path file;  ///< empty: no file can be written, as for a remote package
    InputAxes axes;
    Story story;
    std::string language;               ///< language of the shown texts
    std::string trouble;                ///< error in the file, or reason why it is read-only; empty: none
    std::string on_disk;                ///< the file's text when read or saved; empty: no file
    bool changed = false;               ///< edited since then
    std::optional<std::size_t> open{};  ///< the note whose card is shown
    struct Playing {
        std::size_t tour;
        double start;  ///< seconds
    };
    std::optional<Playing> playing{};
    Story saved{};  ///< the story when read or saved

    bool editable() const { return !file.empty() && trouble.empty(); }
    bool any() const { return !story.notes.empty() || !story.tours.empty(); }
};

/// Reads the story next to a package or a scene file; a new story is in the window's language. Errors are
/// reported in `trouble`.
ActiveStory active_story(const std::filesystem::path& package, const InputAxes& axes,
                         const std::string& language);

/// Opens a note's card and flies to its view, if it has one.
void open_note(ActiveStory& active, Viewpoint& viewpoint, std::size_t note, double now);

/// Starts a tour at the current camera. Does nothing if one of the stops has no view.
void play_tour(ActiveStory& active, Session& session, std::size_t tour, double now);

/// During a tour, opens the note's card at each stop, and closes it when the flight continues. A tour ends
/// with its flight, or when input interrupts it.
void continue_tour(ActiveStory& active, const Viewpoint& viewpoint, double now);

/// The note at whose stop a tour stands after a time in seconds; nullopt: it is on the way, or stands at a
/// view.
std::optional<std::size_t> note_at_stop(const Story& story, const StoryTour& tour, double seconds);

/// The opening view, or nullopt if the story has none.
std::optional<Navigation> opening_of(const ActiveStory& active);

/// If a different language was chosen in the window or in the story, applies it to both. If none was chosen,
/// both have the story's.
void follow_language(ActiveStory& active, std::string& in_use, const std::string& chosen);

/// Writes the story to its file. Throws Error(usage) if another program has changed the file since it was
/// read, and the errors of write_story().
void save(ActiveStory& active);
/// Does the same, and reports the file or the failure. Returns whether the story is saved.
bool save(ActiveStory& active, Message& message, double now);

}  // namespace vantage
