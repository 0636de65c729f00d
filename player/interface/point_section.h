#pragma once
#include "player/interface/controls.h"
#include "player/interface/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// How the point cloud is shown. Nothing for a package without one.
void point_panel(Controls& controls, Session& session, const Renderer& renderer);

}  // namespace vantage
