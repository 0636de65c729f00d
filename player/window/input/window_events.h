#pragma once
#include <string>
#include <vector>

#include "player/interface/state/user_input.h"

namespace vantage {

/// What has happened in the window since it was last asked.
struct WindowEvents {
    UserInput input;
    std::vector<std::string> dropped;  ///< files
    bool any = false;                  ///< one of these, or another: mouse, text, size, focus
};

}  // namespace vantage
