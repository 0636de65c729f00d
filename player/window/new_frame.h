#pragma once
#include "player/interface/state/user_input.h"

struct GLFWwindow;

namespace vantage {

/// Where a window has the mouse.
PointerState mouse_of(GLFWwindow* window);

/// Begins ImGui's frame with the user's input. ImGui reads which keys are down: those released since the
/// last frame are, for this one; before ImGui 1.87 also Ctrl, which the caller releases after the frame, if
/// it was not down before. The pointer is where the input says, or else where the mouse is.
void new_frame(const PointerState& mouse, const UserInput& input);

/// Before a turn of the wheel: since ImGui 1.87, tells it where the mouse is by now, which the wheel is for.
void point_before_wheel(GLFWwindow* window);

}  // namespace vantage
