#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// The bar along the lower edge, with what every visitor needs.
void visitor_bar(Controls& controls, Session& session, const Renderer& renderer, const View& view,
                 const Area& area, double now);

}  // namespace vantage
