#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

namespace vantage {

/// Reads a number that is the whole of `text`, independent of the locale, as programs write them: "+1.5", and
/// for integers also "331.0" and "1e3". False, and `value` unchanged, if it is none or does not fit T.
template <class T>
bool parse_number(std::string_view text, T& value) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const char* end = text.data() + text.size();
    T parsed{};
    if (const auto [p, error] = std::from_chars(text.data(), end, parsed); error == std::errc{} && p == end) {
        value = parsed;
        return true;
    }
    if constexpr (std::is_integral_v<T>) {
        double real = 0;
        const bool whole = parse_number(text, real) && real == std::floor(real) &&
                           real >= double(std::numeric_limits<T>::min()) &&
                           std::abs(real) < 9007199254740992.0 &&
                           real <= double(std::numeric_limits<T>::max());
        if (whole) value = T(real);
        return whole;
    }
    return false;
}

/// A number that consists of decimal digits only; nothing if it is anything else or exceeds 64 bits.
inline std::optional<std::uint64_t> parse_digits(std::string_view digits) {
    std::uint64_t number = 0;
    const bool only = digits.find_first_not_of("0123456789") == digits.npos && parse_number(digits, number);
    return only ? std::optional(number) : std::nullopt;
}

}  // namespace vantage
