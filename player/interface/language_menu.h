#pragma once
#include <string>

#include "player/interface/sections/controls.h"
#include "player/interface/state/window_state.h"

namespace vantage {

/// The name of a language in that language, for users who do not know the current one; its code if unknown.
std::string own_name(const std::string& code);
/// Menu items for the languages of the window and of the story; selecting one changes the window's language.
void language_items(Controls& controls, WindowState& window);

}  // namespace vantage
