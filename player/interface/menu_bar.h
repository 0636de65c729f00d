#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The menu bar at the top of the window, for experts.
void menu_bar(Controls& controls, Session& session, const Renderer& renderer, double now);

}  // namespace vantage
