#pragma once
#include <string>

namespace vantage {

/// Text escaped for HTML and XML.
std::string escaped(const std::string& text);
/// The same as a sentence: with a capital letter (if it begins with one of a to z) and a period.
std::string sentence(std::string text);

}  // namespace vantage
