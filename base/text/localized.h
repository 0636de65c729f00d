#pragma once
#include <optional>
#include <string>
#include <string_view>

/// Numbers as shown in the window, with the decimal separator of its language. Not for files or the command
/// line. For use on the same thread as translation.h.
namespace vantage {

/// "." or ",", as defined in the catalog.
const char* decimal_separator();

/// Like formatted(), but with that separator in numbers with a fraction.
[[gnu::format(printf, 1, 2)]] std::string localized(const char* format, ...);
/// The same for a finished text: points between digits are treated as decimal separators.
std::string localized_numbers(std::string text);

/// Parses a finite number typed by a user, with a decimal point or comma and without thousands separators.
std::optional<double> typed_number(std::string_view text);

}  // namespace vantage
