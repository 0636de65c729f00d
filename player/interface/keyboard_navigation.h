#pragma once
#include <imgui.h>

#include "player/interface/state/window_state.h"

/// Keyboard navigation: arrow keys move between controls, Space and Enter activate a control, Esc leaves it,
/// Ctrl+Tab and Alt switch panels. Other keys keep their function in the program.
namespace vantage {

/// Enables keyboard navigation in ImGui's context.
void navigate_by_keyboard();
/// Records at the end of a frame whether a control has the navigation focus and therefore uses these keys.
void note_navigation(WindowState& window);
/// Removes the keys used by the focused control from the program's input.
void leave_keys_to_navigation(WindowState& window);
/// Draws the focus mark on ImGui's last item if it has the navigation focus; ImGui omits it for invisible
/// buttons. Returns whether the item has the focus.
bool mark_if_navigated();

}  // namespace vantage
