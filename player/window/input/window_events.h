#pragma once
#include <string>
#include <vector>

#include "player/interface/state/user_input.h"

namespace vantage {

/// The window's events since the last call.
struct WindowEvents {
    UserInput input;
    std::vector<std::string> dropped;  ///< files
    bool any = false;                  ///< any event, including mouse, text, size, focus
};

}  // namespace vantage
