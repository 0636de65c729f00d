#include "base/text/localized.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>

#include "base/text/formatted.h"
#include "base/text/parse_number.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

constexpr char begin = '\1', end = '\2';  ///< marks before and after a number with a fraction

/// The format, with a mark before and after each conversion of a floating-point number, such as "%.1f".
std::string with_marks(std::string_view format) {
    std::string out;
    while (!format.empty()) {
        const std::size_t length = format[0] != '%' ? std::min(format.find('%'), format.size())
                                                    : format.find_first_not_of("-+ #0123456789.*hlLqjzt", 1);
        const std::string_view piece =
            format.substr(0, length < format.size() ? length + (format[0] == '%') : format.size());
        format.remove_prefix(piece.size());
        const bool fraction =
            piece[0] == '%' && std::string_view("aAeEfFgG").find(piece.back()) != std::string_view::npos;
        out += fraction ? begin + std::string(piece) + end : std::string(piece);
    }
    return out;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

const char* decimal_separator() { return tr(MARKED_IN("decimal separator", ".")); }

std::string localized(const char* format, ...) {
    const std::string separator = decimal_separator();
    std::va_list arguments;
    va_start(arguments, format);
    const std::string marked = formatted_list(with_marks(format).c_str(), arguments);
    va_end(arguments);
    std::string out;
    bool number = false;
    for (const char c : marked)
        if (c == begin || c == end)
            number = c == begin;
        else if (number && c == '.')
            out += separator;
        else
            out += c;
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
