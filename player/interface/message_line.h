#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/message.h"
#include "player/view/view.h"

namespace vantage {

/// The message, if there is one, at the top of the free part of the window.
void message_line(Controls& controls, Message& message, const Area& free, double now);

}  // namespace vantage
