#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Settings of the point cloud. The package must have a point cloud.
void point_section(Controls& controls, Session& session, const Renderer& renderer);

}  // namespace vantage
