#pragma once
#include <imgui.h>

#include "player/interface/state/window_state.h"

/// Controls are used by keys alone: arrow keys go from one to the next, Space and Enter use it, Esc leaves
/// it, Ctrl+Tab and Alt go to another panel. Keys of the program work meanwhile, but for those.
namespace vantage {

/// Turns it on in ImGui's context.
void navigate_by_keyboard();
/// Notes at the end of a frame whether a control is marked, to which these keys then belong.
void note_navigation(WindowState& window);
/// Takes the keys from the program that belong to the marked control.
void leave_keys_to_navigation(WindowState& window);
/// Marks ImGui's last item if it is the one: ImGui does not for its invisible buttons. Whether it is.
bool mark_if_navigated();

}  // namespace vantage
