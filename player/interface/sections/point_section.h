#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/render/renderer.h"

namespace vantage {

/// Whether points are shown, or their size in a scene without a mesh; and if `more`, all settings of the
/// point cloud. The package must have one.
void point_section(Controls& controls, Session& session, const Renderer& renderer, bool more = true);

}  // namespace vantage
