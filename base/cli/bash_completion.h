#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// A bash script that completes the program's verbs, options, values and files. The package bash-completion
/// loads it; its functions find packages, but are not required.
std::string bash_completion(const DescribedCommand& program);

}  // namespace vantage
