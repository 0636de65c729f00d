#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// Help for mouse, touch and keyboard. Its position is recorded as "Mouse, fingers and keys".
void help_panel(Controls& controls, WindowState& window);

}  // namespace vantage
