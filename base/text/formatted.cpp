#include "base/text/formatted.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace vantage {

std::string formatted(const char* format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    std::string out(std::size_t(std::max(0, length)), '\0');
    std::vsnprintf(out.data(), out.size() + 1, format, again);
    va_end(again);
    va_end(arguments);
    return out;
}

}  // namespace vantage
