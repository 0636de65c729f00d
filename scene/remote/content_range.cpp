#include "scene/remote/content_range.h"

#include <strings.h>

#include "base/text/parse_number.h"

namespace vantage {

namespace {

/// Parses `first-last`, where both are inclusive.
std::optional<ByteRange> parse_bytes(std::string_view text) {
    const auto dash = text.find('-');
    if (dash == std::string_view::npos) return {};
    const auto first = parse_digits(text.substr(0, dash)), last = parse_digits(text.substr(dash + 1));
    if (!first || !last || *first > *last || *last == UINT64_MAX) return {};
    return ByteRange{*first, *last + 1};
}

}  // namespace

std::optional<ContentRange> parse_content_range(std::string_view value) {
    constexpr std::string_view unit = "bytes ";
    if (value.size() < unit.size() || ::strncasecmp(value.data(), unit.data(), unit.size()) != 0) return {};
    value.remove_prefix(unit.size());
    const auto slash = value.find('/');
    if (slash == std::string_view::npos) return {};
    const std::string_view bytes = value.substr(0, slash), total = value.substr(slash + 1);

    ContentRange range;
    if (bytes != "*" && !(range.bytes = parse_bytes(bytes))) return {};
    if (total != "*" && !(range.total = parse_digits(total))) return {};
    if (!range.bytes && !range.total) return {};
    if (range.bytes && range.total && range.bytes->end > *range.total) return {};
    return range;
}

}  // namespace vantage
