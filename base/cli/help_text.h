#pragma once
#include <string>

#include "base/cli/described_command.h"

namespace vantage {

/// "from 1 to 8", or "from 1 up".
std::string limits_text(const DescribedOption& number);
/// How --help shows what an option takes: "NUMBER (from 1 to 8, default 2)".
std::string label_of(const DescribedOption& option);

/// The text of --help, at most 80 columns wide but for examples. Of a command with common options, those
/// alone and few examples, unless `all`. `program`: of a verb; else empty.
std::string help_text(const DescribedCommand& command, const std::string& program, bool all);

}  // namespace vantage
