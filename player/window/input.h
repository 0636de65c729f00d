#pragma once
#include "player/interface/session.h"
#include "player/plan/plan_scene.h"

namespace vantage {

/// Applies this frame's mouse and keyboard input, except input to panels. `now` in seconds.
void apply_input(Session& session, const PlanScene& scene, double now);

bool any_key_down();

}  // namespace vantage
