#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// The session's message, if there is one, at the top of the picture.
void message_line(Controls& controls, Session& session, double now);

}  // namespace vantage
