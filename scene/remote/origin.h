#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vantage {

/// The maximum size of a file in bytes. The size is limited because the cache keeps a table of all blocks of
/// a file.
inline constexpr std::uint64_t largest_remote_file = std::uint64_t(1) << 40;

/// The origin of a cached file, with the values that reveal whether the file has changed on the server.
struct Origin {
    std::string url;                  ///< as returned by shown_url()
    std::uint64_t size = 0;           ///< bytes, 1 to largest_remote_file
    std::string etag, last_modified;  ///< header values, at least one non-empty; weak ETags are ignored
    bool operator==(const Origin&) const = default;
};

/// True if both files have the same content, that is, the same size and the same ETag or, if either lacks an
/// ETag, the same Last-Modified.
bool same_version(const Origin& a, const Origin& b);

/// The origin as stored in the cache. Each line consists of a name, a space and a value. The first line
/// states the format.
std::string text_of(const Origin& origin);
/// Parses the text of an origin; empty if it was not written by text_of().
std::optional<Origin> parse_origin(std::string_view text);
/// True if any version of text_of() may have written the text, even if it is now damaged.
bool begins_like_origin(std::string_view text);

}  // namespace vantage
