#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// The limits of a number as text, such as "from 1 to 8" or "from 1 up".
std::string limits_text(const DescribedOption& number);
/// The label of an option's value in --help, such as "NUMBER (from 1 to 8, default 2)".
std::string label_of(const DescribedOption& option);

/// The text of --help, at most 80 columns wide except for examples. If the command has common options, only
/// those and a few examples are listed unless `all` is set. `program`: for a verb, the program's name;
/// otherwise empty.
std::string help_text(const DescribedCommand& command, const std::string& program, bool all);

}  // namespace vantage
