#pragma once
#include "player/interface/state/user_input.h"

struct GLFWwindow;

namespace vantage {

/// The mouse state of a window.
PointerState mouse_of(GLFWwindow* window);

/// Begins ImGui's frame with the user's input. ImGui polls keys, so keys released since the last frame are
/// reported as down for this frame. Before ImGui 1.87, this also applies to Ctrl, which the caller must
/// release after the frame if it was not down before. The pointer is that of the input, or else the mouse.
void new_frame(const PointerState& mouse, const UserInput& input);

/// Call this before wheel events: since ImGui 1.87, it reports the mouse position to which the wheel applies.
void point_before_wheel(GLFWwindow* window);

}  // namespace vantage
