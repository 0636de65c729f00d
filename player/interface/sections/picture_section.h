#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Background and light, and if `more`, the lamp, glass and exposure.
void picture_content(Controls& controls, Session& session, const Renderer& renderer, bool more = true);
/// The controls of picture_content(), and if `more`, comparison and stereo.
void picture_section(Controls& controls, Session& session, const Renderer& renderer, bool more, double now);

void movement_section(Controls& controls, MovementSettings& movement);

/// Turns the raking light toward a pixel of the window: low at the edges of the picture's free area, and at
/// the viewer in its middle.
void aim_lamp(Session& session, const Eigen::Vector2d& pixel);

/// A handle in the picture that shows where the raking light comes from, and moves it when dragged.
void lamp_handle(Controls& controls, Session& session);

}  // namespace vantage
