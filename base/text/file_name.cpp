#include "base/text/file_name.h"

#include <utf8proc.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>

namespace vantage {
namespace {

/// The characters of Windows-1252 from 0x80 to 0x9f. The other characters are those of Latin-1. Undefined
/// bytes map to themselves.
constexpr std::array<std::uint16_t, 32> windows_1252{
    0x20ac, 0x81,   0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8d,   0x017d, 0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0x9d,   0x017e, 0x0178};

const std::uint8_t* bytes(std::string_view text) {
    return reinterpret_cast<const std::uint8_t*>(text.data());
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        std::int32_t character = 0;
        const auto n = utf8proc_iterate(bytes(text), utf8proc_ssize_t(text.size()), &character);
        if (n <= 0) return false;
        text.remove_prefix(std::size_t(n));
    }
    return true;
}

std::string from_windows_1252(std::string_view text) {
    std::string out;
    for (const char b : text) {
        const auto byte = std::uint8_t(b);
        std::uint8_t encoded[4];
        const std::int32_t character = byte >= 0x80 && byte < 0xa0 ? windows_1252[byte - 0x80u] : byte;
        const auto n = utf8proc_encode_char(character, encoded);
        out.append(encoded, encoded + n);
    }
    return out;
}

}  // namespace

std::string utf8_name(std::string_view name) {
    return is_utf8(name) ? std::string(name) : from_windows_1252(name);
}

std::string comparable_name(std::string_view name) {
    std::string utf8 = utf8_name(name);
    for (char& c : utf8)
        if (c == '\\') c = '/';
    std::uint8_t* mapped = nullptr;
    constexpr auto form = utf8proc_option_t(UTF8PROC_STABLE | UTF8PROC_DECOMPOSE | UTF8PROC_CASEFOLD);
    const auto n = utf8proc_map(bytes(utf8), utf8proc_ssize_t(utf8.size()), &mapped, form);
    const std::unique_ptr<std::uint8_t, decltype(&std::free)> owned(mapped, std::free);
    return n >= 0 ? std::string(mapped, mapped + n) : utf8;
}

std::vector<std::filesystem::path> files_called(const std::filesystem::path& folder, std::string_view name) {
    const std::string wanted = comparable_name(name);
    std::vector<std::filesystem::path> out;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, error))
        if (comparable_name(entry.path().filename().string()) == wanted)
            out.push_back(folder / entry.path().filename());
    return out;
}

}  // namespace vantage
