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

/// What the headers of an answer say. Headers that are not listed here are ignored. In texts, `?` replaces
/// control characters.
struct Answer {
    int status = 0;                               ///< 0 if the status line is malformed
    std::optional<ContentRange> content_range;    ///< none if absent or malformed
    std::string content_range_text;               ///< empty if absent
    std::optional<std::uint64_t> content_length;  ///< none if absent or malformed
    std::string etag;                             ///< empty if absent or weak
    std::string last_modified, content_encoding, location;
    std::size_t header_bytes = 0;  ///< of all lines taken
};

/// Takes one line of the headers, with or without its line end. A status line starts a new answer, because
/// redirects come before the last one.
void take_header_line(Answer& answer, std::string_view line);

/// Why an answer to a request for a range cannot be used, as the rest of a sentence that begins with the
/// URL; empty if it can. `known`: the file as it was opened, or null for the first answer, which may send
/// fewer bytes than asked for if the file is shorter.
std::string flaw_of(const Answer& answer, ByteRange asked, const Origin* known);

/// The file that a flawless answer describes.
Origin origin_of(const Answer& answer, std::string url);

}  // namespace vantage
