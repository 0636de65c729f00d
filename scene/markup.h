#pragma once
#include <string>

namespace vantage {

/// Text as HTML and XML have it.
std::string escaped(const std::string& text);

}  // namespace vantage
