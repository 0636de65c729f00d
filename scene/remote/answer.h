#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/remote/byte_range.h"
#include "scene/remote/content_range.h"
#include "scene/remote/origin.h"

namespace vantage {

/// The headers of a response. Headers not listed here are ignored. In strings, control characters are
/// replaced with `?`.
struct Answer {
    int status = 0;                               ///< 0 if the status line is malformed
    std::optional<ContentRange> content_range;    ///< empty if absent or malformed
    std::string content_range_text;               ///< empty if absent
    std::optional<std::uint64_t> content_length;  ///< empty if absent or malformed
    std::string etag;                             ///< empty if absent or weak
    std::string last_modified, content_encoding, location;
    std::size_t header_bytes = 0;  ///< total length of all header lines so far
};

/// Parses one header line, with or without its line end. A status line starts a new response, because
/// redirects may precede the last response.
void take_header_line(Answer& answer, std::string_view line);

/// The reason why the response to a range request cannot be used, as the rest of a sentence that begins with
/// the URL; empty if it can be used. `known`: the file as it was opened, or null for the first response,
/// which has fewer bytes than requested if the file is shorter.
std::string flaw_of(const Answer& answer, ByteRange asked, const Origin* known);

/// The file that a valid response describes.
Origin origin_of(const Answer& answer, std::string url);

}  // namespace vantage
