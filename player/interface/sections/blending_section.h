#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Settings for blending: mode, weights, and photos.
void blending_section(Controls& controls, Session& session, const Renderer& renderer);

}  // namespace vantage
