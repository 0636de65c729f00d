#include "base/text/formatted.h"

#include <algorithm>
#include <cstdio>

namespace vantage {

std::string formatted(const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    std::string out = formatted_list(format, arguments);
    va_end(arguments);
    return out;
}

std::string formatted_list(const char* format, std::va_list arguments) {
    std::va_list again;
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    std::string out(std::size_t(std::max(0, length)), '\0');
    std::vsnprintf(out.data(), out.size() + 1, format, again);
    va_end(again);
    return out;
}

}  // namespace vantage
