#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "scene/remote/byte_range.h"

namespace vantage {

/// The value of a Content-Range header (RFC 9110, 14.4).
struct ContentRange {
    std::optional<ByteRange> bytes;      ///< not set for `bytes */1000`; otherwise a non-empty range
    std::optional<std::uint64_t> total;  ///< size of the whole file; not set for `bytes 0-99/*`
};

/// Parses a header's value. Empty if the value is malformed, has a unit other than bytes, exceeds 64 bits, or
/// contradicts itself: `bytes 9-3/20`, `bytes 0-20/20`, `bytes */*`.
std::optional<ContentRange> parse_content_range(std::string_view value);

}  // namespace vantage
