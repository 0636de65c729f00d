#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"
#include "player/interface/tour/note_picture.h"

namespace vantage {

/// The notes and tours of a story, and its languages if there are several.
void story_content(Controls& controls, ActiveStory& active, Session& session, double now);
/// The picture, the text and the buttons of the open note. `room`: maximum width of the content, and maximum
/// height of the picture, in pixels.
void note_content(Controls& controls, ActiveStory& active, NotePicture& picture, Session& session,
                  ImVec2 room, double now);
/// "2  The portal"
std::string note_label(const ActiveStory& active, std::size_t note);

/// Least height of the story panel, in multiples of the text height.
inline constexpr float least_story_panel = 5;

/// The story's title, its notes and tours, and its languages if there are several. A click on a note flies to
/// it; a click on a tour plays it. `room`: usable height at the top of the free area, in pixels.
void story_panel(Controls& controls, ActiveStory& active, Session& session, double room, double now);

/// The open note: title, text and picture, with buttons to the previous and next note.
void note_card(Controls& controls, ActiveStory& active, NotePicture& picture, Session& session, double now);

}  // namespace vantage
