#pragma once
#include <strings.h>

#include <string_view>

namespace vantage {

/// True for http:// and https://, in upper or lower case.
inline bool is_url(std::string_view text) {
    const auto starts_with = [&](std::string_view scheme) {
        return text.size() > scheme.size() && ::strncasecmp(text.data(), scheme.data(), scheme.size()) == 0;
    };
    return starts_with("http://") || starts_with("https://");
}

}  // namespace vantage
