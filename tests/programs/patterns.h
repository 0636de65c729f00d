#pragma once

#include <string>
#include <vector>

namespace vantage {

/// All matches of a regular expression (ECMAScript) in a string. Each consists of the whole match, followed
/// by its groups.
std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern);

/// The string with each match of the pattern replaced.
std::string replaced(const std::string& text, const std::string& pattern, const std::string& by);

}  // namespace vantage
