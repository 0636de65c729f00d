#pragma once
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace vantage {

/// A number that consists of decimal digits only; nothing if it is anything else or exceeds 64 bits.
inline std::optional<std::uint64_t> parse_number(std::string_view digits) {
    std::uint64_t number = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, number);
    if (digits.empty() || error != std::errc() || stop != end) return {};
    return number;
}

}  // namespace vantage
