#pragma once
#include <optional>
#include <string>
#include <string_view>

/// Numbers as the window shows them, with the decimal separator of its language. Never for files, nor for the
/// command line. Belongs to the thread of translation.h.
namespace vantage {

/// "." or ","; the catalog has it.
const char* decimal_separator();

/// As formatted(), but for that separator in numbers with a fraction.
[[gnu::format(printf, 1, 2)]] std::string localized(const char* format, ...);
/// The same for a text that is there already: points between digits are taken for separators.
std::string localized_numbers(std::string text);

/// A finite number that somebody has typed, with a point or a comma; without separators of thousands.
std::optional<double> typed_number(std::string_view text);

}  // namespace vantage
