#pragma once
#include "player/composition/object_set.h"
#include "player/interface/sections/controls.h"
#include "player/interface/state/user_command.h"

namespace vantage {

/// The visibility of several objects; and if `more`, their opacity, placement and removal. `size`: the first
/// object's size, in input units. Returns whether the picture changed.
bool object_section(Controls& controls, UserCommands& commands, ObjectSet& objects, double size,
                    bool more = true);

/// Asks whether to open or add a package that was dropped on the window. `file`: the dropped file, or empty.
void drop_dialog(Controls& controls, UserCommands& commands, std::string& file);

}  // namespace vantage
