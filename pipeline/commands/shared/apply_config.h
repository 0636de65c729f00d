#pragma once
#include <string>

#include "base/cli/command.h"

namespace vantage {

/// Applies the settings in a TOML file to `command`: each key is the name of a long option, and its value is
/// the option's argument (a list for options with several values). Options given on the command line take
/// precedence. `name` is a file, or a preset in configs/ without its extension. Throws Error(usage) naming
/// the file and the key.
void apply_config(const Command& command, const std::string& name);

}  // namespace vantage
