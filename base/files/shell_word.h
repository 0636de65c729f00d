#pragma once
#include <string>

namespace vantage {

/// The text as one word of a shell command, in single quotes if it needs them.
std::string shell_word(const std::string& text);

}  // namespace vantage
