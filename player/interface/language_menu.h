#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// Menu items for the languages of the window and of the story; selecting one changes the window's language.
void language_items(Controls& controls, WindowState& window);

}  // namespace vantage
