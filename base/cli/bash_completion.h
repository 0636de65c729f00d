#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// A script for bash that completes the program's verbs, options, values and files. It uses functions of the
/// package bash-completion, which loads it, to find packages, and works without.
std::string bash_completion(const DescribedCommand& program);

}  // namespace vantage
