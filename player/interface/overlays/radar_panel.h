#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// A map from above [P]: the model's extent, the cameras with their directions, and the viewer. A click flies
/// to the photo.
void radar_panel(Controls& controls, Session& session, const Renderer& renderer, const View& view,
                 double now);

}  // namespace vantage
