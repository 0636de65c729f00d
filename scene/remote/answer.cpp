#include "scene/remote/answer.h"

#include <strings.h>

#include <algorithm>

#include "base/text/parse_number.h"

namespace vantage {

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r\n";
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) + 1 - first);
}

/// Replaces characters that would break a line or control a terminal.
std::string printable(std::string_view text) {
    std::string shown(text);
    std::ranges::replace_if(
        shown, [](unsigned char c) { return c < 32 || c == 127; }, '?');
    return shown;
}

/// The beginning of a value, in quotes, for a message.
std::string quoted(const std::string& value) {
    constexpr std::size_t most = 100;  // bytes
    std::string text = "'";
    text += value.substr(0, most);
    return text += value.size() > most ? "...'" : "'";
}

bool same_word(std::string_view a, std::string_view b) {
    return a.size() == b.size() && ::strncasecmp(a.data(), b.data(), a.size()) == 0;
}

/// The status code, such as 206 in `HTTP/1.1 206 Partial Content`.
int status_of(std::string_view line) {
    const auto space = line.find(' ');
    if (space == std::string_view::npos) return 0;
    const auto status = parse_digits(line.substr(space + 1, 3));
    return status && *status >= 100 && *status < 1000 ? int(*status) : 0;
}

std::string words(ByteRange range) {
    return "bytes " + std::to_string(range.begin) + " to " + std::to_string(range.end - 1);
}

std::string status_flaw(const Answer& answer, ByteRange asked) {
    std::string text = "the server responds with " + std::to_string(answer.status);
    if (answer.status == 403) text += " (forbidden)";
    if (answer.status == 404) text += " (not found)";
    text += " to a request for " + words(asked) + ", expected 206";
    if (answer.status == 200) text += "; it must support range requests";
    return text;
}

std::string total_flaw(std::uint64_t total, const Origin* known) {
    if (total == 0) return "the file is empty";
    if (known && total != known->size)
        return "the file has changed on the server: it has " + std::to_string(total) + " bytes, expected " +
               std::to_string(known->size);
    if (total > largest_remote_file)
        return "the server states a size of " + std::to_string(total) + " bytes, expected at most " +
               std::to_string(largest_remote_file);
    return {};
}

std::string version_flaw(const Answer& answer, const Origin& known) {
    if (same_version({{}, known.size, answer.etag, answer.last_modified}, known)) return {};
    const bool by_tag = !known.etag.empty();
    const std::string& found = by_tag ? answer.etag : answer.last_modified;
    return "the file has changed on the server: its " + std::string(by_tag ? "ETag" : "Last-Modified") +
           " is " + (found.empty() ? "missing" : quoted(found)) + ", expected " +
           quoted(by_tag ? known.etag : known.last_modified);
}

/// The reason why a response with a status other than 206 cannot be used.
std::string refusal(const Answer& answer, ByteRange asked, const Origin* known) {
    if (answer.status == 416 && answer.content_range && answer.content_range->total)
        if (std::string flaw = total_flaw(*answer.content_range->total, known); !flaw.empty()) return flaw;
    if (answer.status == 200 && answer.content_length == 0) return "the file is empty";
    return status_flaw(answer, asked);
}

std::string range_flaw(const Answer& answer, ByteRange asked, const Origin* known) {
    const std::string expected = ", expected " + words(asked);
    if (answer.content_range_text.empty()) return "the response has no Content-Range" + expected;
    if (!answer.content_range || !answer.content_range->bytes || !answer.content_range->total)
        return "the response has an invalid Content-Range " + quoted(answer.content_range_text) + expected +
               " and the size of the file";
    const std::uint64_t total = *answer.content_range->total;
    if (std::string flaw = total_flaw(total, known); !flaw.empty()) return flaw;
    const ByteRange sent = *answer.content_range->bytes, due{asked.begin, std::min(asked.end, total)};
    if (sent != due) return "the server sends " + words(sent) + ", expected " + words(due);
    if (answer.content_length && *answer.content_length != due.size())
        return "the server sends " + std::to_string(*answer.content_length) + " bytes, expected " +
               std::to_string(due.size()) + " for " + words(due);
    return {};
}

}  // namespace

void take_header_line(Answer& answer, std::string_view line) {
    if (line.starts_with("HTTP/")) {
        answer = {};
        answer.status = status_of(line);
    }
    answer.header_bytes += line.size();
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view name = line.substr(0, colon), value = trimmed(line.substr(colon + 1));
    if (same_word(name, "content-range")) {
        answer.content_range_text = printable(value);
        answer.content_range = parse_content_range(value);
    } else if (same_word(name, "content-length")) {
        answer.content_length = parse_digits(value);
    } else if (same_word(name, "etag")) {
        answer.etag = value.starts_with('"') ? printable(value) : "";
    } else if (same_word(name, "last-modified")) {
        answer.last_modified = printable(value);
    } else if (same_word(name, "content-encoding")) {
        answer.content_encoding = printable(value);
    } else if (same_word(name, "location")) {
        answer.location = value;
    }
}

std::string flaw_of(const Answer& answer, ByteRange asked, const Origin* known) {
    if (answer.status != 206) return refusal(answer, asked, known);
    if (!answer.content_encoding.empty() && !same_word(answer.content_encoding, "identity"))
        return "the response has the Content-Encoding " + quoted(answer.content_encoding) +
               ", expected identity";
    if (std::string flaw = range_flaw(answer, asked, known); !flaw.empty()) return flaw;
    if (known) return version_flaw(answer, *known);
    if (answer.etag.empty() && answer.last_modified.empty())
        return "the response has neither a strong ETag nor Last-Modified, so a change to the file could not "
               "be detected";
    return {};
}

Origin origin_of(const Answer& answer, std::string url) {
    return {std::move(url), answer.content_range->total.value(), answer.etag, answer.last_modified};
}

}  // namespace vantage
