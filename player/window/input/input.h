#pragma once
#include "player/interface/state/session.h"
#include "player/plan/plan_scene.h"

namespace vantage {

/// Applies mouse, touch and keyboard input since the last frame, except input to panels. `now` in seconds.
void apply_input(Session& session, const PlanScene& scene, double now);

/// Whether a key is down, or was down at any time since the last frame.
bool keys_in_use(const UserInput& input);

}  // namespace vantage
