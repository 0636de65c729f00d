#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The toolbar at the bottom, with the functions for visitors.
void visitor_bar(Controls& controls, Session& session, const Renderer& renderer, const View& view,
                 const Area& area, double now);

}  // namespace vantage
