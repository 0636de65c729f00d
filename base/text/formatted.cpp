#include "base/text/formatted.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace vantage {
namespace {

/// Marks before and after a floating-point number; `begin_signed` if positive numbers have a plus sign.
constexpr char begin = '\1', begin_signed = '\2', end = '\3';

/// The format, with marks around each conversion of a floating-point number, such as "%.1f".
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
        if (fraction) out += piece.find('+') != std::string_view::npos ? begin_signed : begin;
        out += piece;
        if (fraction) out += end;
    }
    return out;
}

std::string printed(const char* format, std::va_list arguments) {
    std::va_list again;
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    std::string out(std::size_t(std::max(0, length)), '\0');
    std::vsnprintf(out.data(), out.size() + 1, format, again);
    va_end(again);
    return out;
}

std::string without_sign_of_zero(std::string number, bool has_plus) {
    const std::size_t sign = number.find('-');
    const bool zero = number.find('0') != number.npos && number.find_first_of("123456789") == number.npos;
    if (!zero || sign == number.npos) return number;
    if (has_plus || sign > 0)
        number[sign] = has_plus ? '+' : ' ';
    else
        number.erase(0, 1);
    return number;
}

}  // namespace

std::string formatted(const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    std::string out = formatted_list(format, arguments);
    va_end(arguments);
    return out;
}

std::string formatted_list(const char* format, std::va_list arguments, const std::string& separator) {
    const std::string marked = printed(with_marks(format).c_str(), arguments);
    std::string out;
    for (std::size_t at = 0; at < marked.size(); ++at) {
        const bool begins = marked[at] == begin || marked[at] == begin_signed;
        const std::size_t last = begins ? marked.find(end, at) : marked.npos;
        if (last == marked.npos) {
            out += marked[at];
            continue;
        }
        std::string number =
            without_sign_of_zero(marked.substr(at + 1, last - at - 1), marked[at] == begin_signed);
        if (const std::size_t point = number.find('.'); point != number.npos)
            number.replace(point, 1, separator);
        out += number;
        at = last;
    }
    return out;
}

}  // namespace vantage
