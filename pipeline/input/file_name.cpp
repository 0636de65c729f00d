#include "pipeline/input/file_name.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace vantage {
namespace {

struct Decomposition {
    char16_t character, base, mark;  ///< mark 0: the base alone
};
constexpr Decomposition decompositions[] = {
#include "pipeline/input/decompositions.inc"
};

/// Windows-1252 from 0x80 to 0x9f; the rest is Latin-1. Bytes without a character stand for themselves.
constexpr std::array<char16_t, 32> windows_1252{
    0x20ac, 0x81,   0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8d,   0x017d, 0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x9d,   0x017e, 0x0178};

/// Takes the first character of UTF-8 text; nothing if it is not valid.
std::optional<char32_t> take_character(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return std::uint8_t(text[i]); };
    const std::uint8_t first = byte(0);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length == 0 || length > text.size()) return {};
    constexpr std::uint8_t first_bits[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
    char32_t c = first & first_bits[length];
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return {};
        c = c << 6 | (byte(i) & 0x3f);
    }
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (c < least[length] || c > 0x10ffff || (c >= 0xd800 && c < 0xe000)) return {};
    text.remove_prefix(length);
    return c;
}

std::u32string characters(std::string_view name) {
    std::u32string out;
    for (std::string_view rest = name; !rest.empty();) {
        if (const auto c = take_character(rest)) {
            out += *c;
            continue;
        }
        out.clear();  // one byte that is not UTF-8: the whole name is of the other encoding
        for (const char b : name) {
            const auto byte = std::uint8_t(b);
            out += byte >= 0x80 && byte < 0xa0 ? char32_t(windows_1252[byte - 0x80u]) : char32_t(byte);
        }
        return out;
    }
    return out;
}

void append_utf8(char32_t c, std::string& out) {
    if (c < 0x80) {
        out += char(c);
    } else if (c < 0x800) {
        out += {char(0xc0 | c >> 6), char(0x80 | (c & 0x3f))};
    } else if (c < 0x10000) {
        out += {char(0xe0 | c >> 12), char(0x80 | (c >> 6 & 0x3f)), char(0x80 | (c & 0x3f))};
    } else {
        out += {char(0xf0 | c >> 18), char(0x80 | (c >> 12 & 0x3f)), char(0x80 | (c >> 6 & 0x3f)),
                char(0x80 | (c & 0x3f))};
    }
}

char32_t lower_case(char32_t c) {
    const bool by_32 = (c >= 'A' && c <= 'Z') || (c >= 0xc0 && c <= 0xde && c != 0xd7) ||
                       (c >= 0x391 && c <= 0x3a9) || (c >= 0x410 && c <= 0x42f);
    if (by_32) return c + 32;
    return c >= 0x400 && c <= 0x40f ? c + 80 : c;
}

void append_decomposed(char32_t c, std::string& out) {
    constexpr char32_t hangul = 0xac00, hangul_end = 0xd7a4;
    if (c >= hangul && c < hangul_end) {  // Unicode 3.12: leading consonant, vowel, trailing consonant
        const char32_t i = c - hangul;
        append_utf8(0x1100 + i / 588, out);
        append_utf8(0x1161 + i % 588 / 28, out);
        if (i % 28) append_utf8(0x11a7 + i % 28, out);
        return;
    }
    const auto found = std::ranges::lower_bound(decompositions, c, {}, &Decomposition::character);
    if (found == std::end(decompositions) || found->character != c) return append_utf8(lower_case(c), out);
    append_decomposed(found->base, out);
    if (found->mark) append_utf8(found->mark, out);
}

}  // namespace

std::string utf8_name(std::string_view name) {
    std::string out;
    for (const char32_t c : characters(name)) append_utf8(c, out);
    return out;
}

std::string comparable_name(std::string_view name) {
    std::string out;
    for (const char32_t c : characters(name)) append_decomposed(c == '\\' ? U'/' : c, out);
    return out;
}

}  // namespace vantage
