#pragma once
#include <array>
#include <optional>

#include "player/interface/overlays/note_markers.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"

namespace vantage {

/// The panel for writing a story. The panel adds notes at the surface point in the center of the view, edits
/// the open note, sorts the notes, makes a tour of them, and saves the story. Texts are edited in the
/// displayed language.
class StoryEditor {
  public:
    void show(Controls& controls, ActiveStory& active, Session& session, const View& view,
              const SurfaceAt& surface, double now);

  private:
    void add(ActiveStory& active, const Session& session, const View& view, const SurfaceAt& surface);
    void fields(Controls& controls, ActiveStory& active);
    void buttons(Controls& controls, ActiveStory& active, const Session& session);
    void take(const ActiveStory& active);

    std::optional<std::size_t> edited_;  ///< the note in the text fields
    std::string language_;               ///< language of the edited texts
    std::array<char, 501> title_{};
    std::array<char, 20001> text_{};
    std::array<char, 501> picture_{};
};

}  // namespace vantage
