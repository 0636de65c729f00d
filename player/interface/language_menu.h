#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// The items of a menu of the languages that the window has; the one chosen becomes the window's.
void language_items(Controls& controls, WindowState& window);

}  // namespace vantage
