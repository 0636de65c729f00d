#pragma once
#include <cstdarg>
#include <string>

namespace vantage {

/// The text that printf would print.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
/// The text that vprintf would print.
[[gnu::format(printf, 1, 0)]] std::string formatted_list(const char* format, std::va_list arguments);

}  // namespace vantage
