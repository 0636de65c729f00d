#pragma once
#include <algorithm>
#include <cctype>
#include <string>

namespace vantage {

/// Converts ASCII letters to lower case.
inline std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

}  // namespace vantage
