#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/message.h"
#include "player/interface/state/window_state.h"
#include "player/view/view.h"

namespace vantage {

/// Shows the message, if any, at the top of the free area, above panels. The message about a file has buttons
/// that show its folder and copy its path, and stays while the pointer is over it.
void message_line(Controls& controls, Message& message, WindowState& window, double now);

}  // namespace vantage
