#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The blending mode, and if `more`, weights and the selection of photos.
void blending_section(Controls& controls, Session& session, const Renderer& renderer, bool more = true);

}  // namespace vantage
