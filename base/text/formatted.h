#pragma once
#include <string>

namespace vantage {

/// The text that printf would print.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace vantage
