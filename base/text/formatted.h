#pragma once
#include <cstdarg>
#include <string>

namespace vantage {

/// The text that printf would print, but without the minus sign of a floating-point number that is printed as
/// zero.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
/// Like formatted(), with `separator` instead of the decimal point of floating-point numbers.
[[gnu::format(printf, 1, 0)]] std::string formatted_list(const char* format, std::va_list arguments,
                                                         const std::string& separator = ".");

}  // namespace vantage
