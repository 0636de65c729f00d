#pragma once
#include <string>

#include "player/interface/sections/controls.h"
#include "player/view/view.h"

namespace vantage {

/// The caption of a tour: a title, which may be empty, above a text, at the bottom of the free area.
void caption(Controls& controls, const std::string& title, const std::string& text, const Area& free);

}  // namespace vantage
