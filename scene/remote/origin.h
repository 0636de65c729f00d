#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vantage {

/// Larger files are refused (bytes): the cache keeps a table of all blocks of a file.
inline constexpr std::uint64_t largest_remote_file = std::uint64_t(1) << 40;

/// Where a cached file comes from, and by what a change on the server is recognized.
struct Origin {
    std::string url;                  ///< as shown_url() gives it
    std::uint64_t size = 0;           ///< bytes, 1 to largest_remote_file
    std::string etag, last_modified;  ///< values of the headers; not both are empty; a weak ETag is none
    bool operator==(const Origin&) const = default;
};

/// True if both are the same content: equal in size and ETag, or in Last-Modified if either has no ETag.
bool same_version(const Origin& a, const Origin& b);

/// As stored in the cache: lines of a name, a space and a value, of which the first gives the format.
std::string text_of(const Origin& origin);
/// Nothing if the text is not what text_of() writes.
std::optional<Origin> parse_origin(std::string_view text);
/// True if text_of(), of this version or another, may have written the text, even if it is damaged now.
bool begins_like_origin(std::string_view text);

}  // namespace vantage
