#pragma once
#include "player/interface/controls.h"
#include "player/interface/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Draws the photos' frusta over the scene: the nearer, the greener; the more similar in
/// direction, the redder [M]; brighter and thicker if in use.
void draw_frusta(const Session& session, const Renderer& renderer, const View& view);

/// A map from above [P]: the model's extent, the cameras with their directions, and the viewer. A click flies
/// to that photo.
void radar_panel(Controls& controls, Session& session, const Renderer& renderer, const View& view,
                 double now);

}  // namespace vantage
