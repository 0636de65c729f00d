#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// A zsh script that completes the program's verbs, options, values and files, with descriptions.
std::string zsh_completion(const DescribedCommand& program);

}  // namespace vantage
