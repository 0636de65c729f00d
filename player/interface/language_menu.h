#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// The items of a menu of the languages that the window has; the one chosen becomes the session's.
void language_items(Controls& controls, Session& session);

}  // namespace vantage
