#pragma once

#include <string>
#include <vector>

namespace vantage {

/// Where a regular expression (ECMAScript) matches in a text, one after the other: the whole match, then its
/// groups.
std::vector<std::vector<std::string>> matches(const std::string& text, const std::string& pattern);

/// The text with each match in a text replaced.
std::string replaced(const std::string& text, const std::string& pattern, const std::string& by);

}  // namespace vantage
