#pragma once
#include <algorithm>
#include <string>

namespace vantage {

/// Whether a message consists of exactly one line.
inline bool one_line(const std::string& text) {
    return !text.empty() && std::ranges::count(text, '\n') == 1 && text.back() == '\n';
}

}  // namespace vantage
