#include "scene/remote/origin.h"

#include <utility>

#include "base/text/parse_number.h"

namespace vantage {

namespace {

constexpr std::string_view mark = "vantage-remote ", version = "1";

/// Removes the next line, which must have this name, from the text and returns its value.
std::optional<std::string_view> take_line(std::string_view& text, std::string_view name) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos || !text.starts_with(name)) return {};
    const std::string_view value = text.substr(name.size(), end - name.size());
    text.remove_prefix(end + 1);
    return value;
}

}  // namespace

bool same_version(const Origin& a, const Origin& b) {
    if (a.size != b.size) return false;
    if (!a.etag.empty() && !b.etag.empty()) return a.etag == b.etag;
    return !a.last_modified.empty() && a.last_modified == b.last_modified;
}

std::string text_of(const Origin& o) {
    std::string text(mark);
    text += version;
    for (const auto& [name, value] :
         {std::pair("url ", o.url), std::pair("size ", std::to_string(o.size)), std::pair("etag ", o.etag),
          std::pair("last-modified ", o.last_modified)})
        text.append("\n").append(name).append(value);
    return text + "\n";
}

std::optional<Origin> parse_origin(std::string_view text) {
    const auto format = take_line(text, mark);
    if (format != version) return {};
    const auto url = take_line(text, "url "), size = take_line(text, "size "),
               etag = take_line(text, "etag "), last_modified = take_line(text, "last-modified ");
    if (!url || !size || !etag || !last_modified || !text.empty()) return {};
    const auto bytes = parse_digits(*size);
    if (url->empty() || !bytes || *bytes == 0 || *bytes > largest_remote_file) return {};
    if (etag->empty() && last_modified->empty()) return {};
    return Origin{std::string(*url), *bytes, std::string(*etag), std::string(*last_modified)};
}

bool begins_like_origin(std::string_view text) { return text.starts_with(mark); }

}  // namespace vantage
