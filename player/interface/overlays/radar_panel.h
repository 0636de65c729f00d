#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// A map from above [P]: the model's extent, the cameras with their directions, and the viewer. Clicking a
/// camera flies to its photo.
void radar_panel(Controls& controls, Session& session, const Renderer& renderer, const View& view,
                 double now);

}  // namespace vantage
