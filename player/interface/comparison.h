#pragma once
#include "player/interface/controls.h"
#include "player/interface/session.h"
#include "player/plan/plan_scene.h"

namespace vantage {

/// What the picture compares: names of both sides, and the wiper's line, which can be dragged. `frame`: the
/// whole window, pixels.
void comparison(Controls& controls, Session& session, const PlanScene& scene, const Area& frame);

/// What the false colors of the picture mean.
void false_color_legend(const Session& session);

}  // namespace vantage
