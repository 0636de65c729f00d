#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/interface/state/session.h"
#include "player/tour/story_views.h"
#include "scene/story/story.h"

namespace vantage {

/// The story of what is shown, and where its telling stands.
struct ActiveStory {
    std::filesystem::path file;  ///< empty: there is no place for a story, as with a package on a server
    InputAxes axes;
    Story story;
    std::string language;  ///< that texts are shown in
    std::string trouble;   ///< why the file was not used, or why it cannot be edited; empty: nothing
    std::string on_disk;   ///< the file's text when it was read or saved; empty: there was none
    bool changed = false;  ///< since then
    std::optional<std::size_t> open{};  ///< the note whose card is shown
    struct Playing {
        std::size_t tour;
        double start;  ///< seconds
    };
    std::optional<Playing> playing{};

    bool any() const { return !story.notes.empty() || !story.tours.empty(); }
};

/// Reads the story beside a package or a scene file. What is wrong with it becomes `trouble`.
ActiveStory active_story(const std::filesystem::path& package, const InputAxes& axes,
                         const std::string& language);

/// Opens a note's card and flies to its view, if it has one.
void open_note(ActiveStory& active, Viewpoint& viewpoint, std::size_t note, double now);

/// Starts a tour from where the camera is. Does nothing if a stop has no view.
void play_tour(ActiveStory& active, Session& session, std::size_t tour, double now);

/// While a tour plays, opens the card of the note where it stops, and closes it when it flies on. A tour ends
/// with its flight, also if input interrupts that.
void continue_tour(ActiveStory& active, const Viewpoint& viewpoint, double now);

/// The opening view, or nothing if the story has none.
std::optional<Navigation> opening_of(const ActiveStory& active);

/// Has window and story follow the language that was chosen in either, if it is not the one in use.
void follow_language(ActiveStory& active, std::string& in_use, const std::string& chosen);

/// Writes the story to its file. Throws Error(usage) if another program has changed the file since it was
/// read, and what write_story() throws.
void save(ActiveStory& active);

}  // namespace vantage
