#pragma once
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

namespace vantage {

/// Non-finite numbers as Microsoft's C library wrote them until 2015: "1.#INF", "-1.#IND", "1.#QNAN0".
template <class T>
std::optional<T> parse_not_finite(std::string_view text) {
    const bool negative = text.starts_with('-');
    text.remove_prefix(negative);
    if (text.starts_with("1.#INF"))
        return negative ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::infinity();
    if (text.starts_with("1.#QNAN") || text.starts_with("1.#SNAN") || text.starts_with("1.#IND"))
        return std::numeric_limits<T>::quiet_NaN();
    return {};
}

/// Parses the whole of `text` as a number, independently of the locale. Accepts forms that other programs
/// write: "+1.5", "1e-400" (which becomes 0), and for integers also "331.0" and "1e3". Returns false and
/// leaves `value` unchanged if the text is not a number or the number does not fit T.
template <class T>
bool parse_number(std::string_view text, T& value) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const char* end = text.data() + text.size();
    T parsed{};
    const auto [p, error] = std::from_chars(text.data(), end, parsed);
    if (error == std::errc{} && p == end) {
        value = parsed;
        return true;
    }
    if constexpr (std::is_floating_point_v<T>) {
        const bool too_small = error == std::errc::result_out_of_range && p == end &&
                               (text.find("e-") != text.npos || text.find("E-") != text.npos);
        const std::optional<T> other = too_small ? std::optional<T>(0) : parse_not_finite<T>(text);
        if (other) value = *other;
        return other.has_value();
    } else {
        double real = 0;
        const bool whole = parse_number(text, real) && real == std::floor(real) &&
                           real >= double(std::numeric_limits<T>::min()) &&
                           std::abs(real) < 9007199254740992.0 &&
                           real <= double(std::numeric_limits<T>::max());
        if (whole) value = T(real);
        return whole;
    }
}

/// Parses a number that consists only of decimal digits; empty for anything else and for numbers that exceed
/// 64 bits.
inline std::optional<std::uint64_t> parse_digits(std::string_view digits) {
    std::uint64_t number = 0;
    const bool only = digits.find_first_not_of("0123456789") == digits.npos && parse_number(digits, number);
    return only ? std::optional(number) : std::nullopt;
}

}  // namespace vantage
