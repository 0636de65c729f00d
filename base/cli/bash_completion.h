#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// A bash script that completes the program's verbs, options, values and files. It is loaded by the
/// bash-completion package, whose functions complete the names of package files, if it is installed.
std::string bash_completion(const DescribedCommand& program);

}  // namespace vantage
