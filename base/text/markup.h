#pragma once
#include <string>

namespace vantage {

/// The text escaped for HTML and XML.
std::string escaped(const std::string& text);
/// The text as a sentence: capitalized if it begins with a letter from a to z, and ending with a period.
std::string sentence(std::string text);

}  // namespace vantage
