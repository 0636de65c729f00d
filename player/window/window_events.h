#pragma once
#include <array>
#include <string>
#include <vector>

#include "player/interface/drag.h"
#include "player/interface/key_press.h"

namespace vantage {

/// What has happened in the window since it was last asked.
struct WindowEvents {
    std::vector<KeyPress> keys;        ///< in order, also those that were released again
    std::vector<std::string> dropped;  ///< files
    bool double_clicked = false;       ///< by the left button
    std::array<Drag, 3> drags{};       ///< by button: left, right, middle
    bool any = false;                  ///< one of these, or another: mouse, text, size, focus
};

}  // namespace vantage
