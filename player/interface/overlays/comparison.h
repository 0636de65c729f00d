#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"
#include "player/plan/plan_scene.h"

namespace vantage {

/// Labels of a comparison's two sides, and the swipe's draggable line. `frame`: the whole window, in pixels.
void comparison(Controls& controls, Session& session, const PlanScene& scene, const Area& frame);

/// Flies to the photo that agrees best with the view and compares the model with it, or ends a comparison in
/// progress.
void toggle_comparison(Session& session, const PlanScene& scene, const View& view, double now);

/// Legend of the picture's false colors.
void false_color_legend(Controls& controls, const Session& session, const PlanScene& scene);

}  // namespace vantage
