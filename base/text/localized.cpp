#include "base/text/localized.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>

#include "base/text/formatted.h"
#include "base/text/parse_number.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

const char* decimal_separator() { return tr(MARKED_IN("decimal separator", ".")); }

std::string localized(const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    std::string out = formatted_list(format, arguments, decimal_separator());
    va_end(arguments);
    return out;
}

std::string localized_numbers(std::string text) {
    const std::string separator = decimal_separator();
    if (separator == ".") return text;
    for (std::size_t at = 1; at + 1 < text.size(); ++at)
        if (text[at] == '.' && is_digit(text[at - 1]) && is_digit(text[at + 1]))
            text.replace(at, 1, separator);
    return text;
}

std::optional<double> typed_number(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
    if (first == text.npos) return {};
    std::string number(text.substr(first, last - first + 1));
    std::ranges::replace(number, ',', '.');
    double value = 0;
    if (!parse_number(number, value) || !std::isfinite(value)) return {};
    return value;
}

}  // namespace vantage
