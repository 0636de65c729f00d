#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The expert's menu along the upper edge.
void menu_bar(Controls& controls, Session& session, const Renderer& renderer, double now);

}  // namespace vantage
