#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// What mouse and keys do. Noted as "Mouse, fingers and keys".
void help_panel(Controls& controls, WindowState& window);

}  // namespace vantage
