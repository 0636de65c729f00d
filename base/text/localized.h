#pragma once
#include <optional>
#include <string>
#include <string_view>

/// Numbers as the window shows them, with the decimal separator of its language. These numbers are not for
/// files or the command line. Use these functions on the same thread as those of translation.h.
namespace vantage {

/// The decimal separator: "." or ",", as defined in the catalog.
const char* decimal_separator();

/// Like formatted(), but with decimal_separator() in numbers with a fraction.
[[gnu::format(printf, 1, 2)]] std::string localized(const char* format, ...);
/// Replaces decimal points in finished text with decimal_separator(). Every point between digits counts as a
/// decimal point.
std::string localized_numbers(std::string text);

/// Parses a finite number typed by a user, with a decimal point or comma and without thousands separators.
std::optional<double> typed_number(std::string_view text);

}  // namespace vantage
