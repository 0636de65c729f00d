#pragma once
#include <string>
#include <vector>

#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// A line of the help, in English: "Ctrl+Q" and "quit".
struct Shortcut {
    std::string keys, action;
    bool for_public = false;  ///< also works in a kiosk
};
std::vector<Shortcut> shortcuts();

/// Help for mouse, touch and keyboard; in a kiosk, for touch alone. Its position is recorded as "Mouse,
/// fingers and keys".
void help_panel(Controls& controls, WindowState& window);

}  // namespace vantage
