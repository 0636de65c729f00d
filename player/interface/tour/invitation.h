#pragma once
#include <string>

#include "player/interface/sections/controls.h"
#include "player/view/view.h"

namespace vantage {

/// The caption of an idle kiosk: a title, which may be empty, above "Touch to begin", at the bottom of the
/// free area.
void invitation(Controls& controls, const std::string& title, const Area& free);

}  // namespace vantage
