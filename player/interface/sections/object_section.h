#pragma once
#include "player/composition/object_set.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/user_command.h"

namespace vantage {

/// The list of objects: shown or not, one alone, where each stands, added and removed. `size`: of the first
/// one, input units. Returns whether anything in the picture changed.
bool object_section(Controls& controls, UserCommands& commands, ObjectSet& objects, double size);

/// Asks whether a package that was dropped on the window is to be opened or added. `file`: the one that is
/// asked about, or empty.
void drop_dialog(Controls& controls, UserCommands& commands, std::string& file);

}  // namespace vantage
