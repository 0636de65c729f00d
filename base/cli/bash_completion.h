#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// A bash script that completes the program's verbs, options, values and files. The bash-completion framework
/// loads this script. If the framework's functions are available, they complete the names of .vantage files;
/// the script works without them.
std::string bash_completion(const DescribedCommand& program);

}  // namespace vantage
