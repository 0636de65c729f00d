#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Background and light, and if `more`, the lamp, glass and exposure.
void picture_content(Controls& controls, Session& session, const Renderer& renderer, bool more = true);
/// The controls of picture_content(), and if `more`, comparison and stereo.
void picture_section(Controls& controls, Session& session, const Renderer& renderer, bool more);

void movement_section(Controls& controls, MovementSettings& movement);

}  // namespace vantage
