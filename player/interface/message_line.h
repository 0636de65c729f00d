#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/message.h"
#include "player/view/view.h"

namespace vantage {

/// Shows the message, if any, at the top of the free area.
void message_line(Controls& controls, Message& message, const Area& free, double now);

}  // namespace vantage
