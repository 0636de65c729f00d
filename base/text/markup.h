#pragma once
#include <string>

namespace vantage {

/// Text escaped for HTML and XML.
std::string escaped(const std::string& text);
/// The same as a sentence: capitalized (if it begins with one of a to z) and ending with a period.
std::string sentence(std::string text);

}  // namespace vantage
