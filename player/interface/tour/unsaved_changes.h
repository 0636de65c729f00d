#pragma once
#include <optional>

#include "player/interface/sections/controls.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"

namespace vantage {

/// Asks whether to save the story and the measurements before the window closes or shows another scene.
class UnsavedChanges {
  public:
    /// Holds the commands Quit and OpenFile back while there are unsaved changes, until the user has
    /// answered.
    void ask(Controls& controls, Session& session, ActiveStory& active, MeasurePanel& measure, double now);

  private:
    std::optional<UserCommand> next_;  ///< the command that is held back
    bool answered_ = false;            ///< the command may be executed
};

}  // namespace vantage
