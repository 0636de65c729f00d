#pragma once
#include <string>

namespace vantage {

/// Text escaped for HTML and XML.
std::string escaped(const std::string& text);

}  // namespace vantage
