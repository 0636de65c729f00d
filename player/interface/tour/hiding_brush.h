#pragma once
#include "player/interface/overlays/note_markers.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/active_story.h"

namespace vantage {

/// Hides pieces of the model and the background in a story: while the brush is on, a click hides the content
/// of a ball as large as the circle around the pointer.
class HidingBrush {
  public:
    /// The controls. `surface`: the model or the background at a pixel; may be empty.
    void show(Controls& controls, ActiveStory& active, Session& session, const View& view,
              const SurfaceAt& surface, double now);

  private:
    void take_click(ActiveStory& active, Session& session, const View& view, const SurfaceAt& surface,
                    double now) const;

    double diameter_ = 40;  ///< pixels
};

}  // namespace vantage
