#pragma once
#include "player/render/renderer.h"
#include "player/session.h"

namespace vantage {

/// The photos' cameras in the scene, drawn over it: greener the nearer, redder the closer in direction [M];
/// the ones in use filled with their thumbnails' outline stronger.
void draw_frusta(const Session& session, const Renderer& renderer, const View& view);

/// From above [P]: the model's extent, the cameras with what they look at, and the viewer.
void radar_panel(Session& session, const Renderer& renderer, const View& view, double now);

}  // namespace vantage
