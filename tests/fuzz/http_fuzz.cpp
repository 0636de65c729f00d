// Reads responses to range requests, and descriptions of cached files. An input is two bytes that select the
// range, then header lines. Checks the guarantees of accepted responses.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/text/error.h"
#include "scene/remote/answer.h"
#include "scene/remote/origin.h"
#include "scene/remote/url.h"
#include "tests/fuzz/support/fuzz_target.h"

using namespace vantage;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

Answer answer_of(std::string_view text) {
    Answer answer;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        take_header_line(answer, text.substr(0, end));
        text.remove_prefix(end == text.npos ? text.size() : end + 1);
    }
    return answer;
}

void judge(const Answer& answer, ByteRange asked, const Origin* known) {
    const std::string flaw = flaw_of(answer, asked, known);
    require(flaw.find('\n') == flaw.npos);
    if (!flaw.empty()) return;
    require(answer.status == 206 && answer.content_range);
    require(answer.content_range->bytes && answer.content_range->total);
    const ByteRange got = *answer.content_range->bytes;
    const std::uint64_t total = *answer.content_range->total;
    require(got == ByteRange{asked.begin, std::min(asked.end, total)} && total <= largest_remote_file);
    require(!answer.content_length || *answer.content_length == got.size());
    require(!answer.etag.empty() || !answer.last_modified.empty());
    if (known) require(total == known->size);
}

}  // namespace

FUZZ_TARGET(http)(const std::uint8_t* bytes, std::size_t size) {
    if (size < 2) return 0;
    const std::string_view text(reinterpret_cast<const char*>(bytes) + 2, size - 2);
    const ByteRange asked{std::uint64_t(bytes[0]) << 12, (std::uint64_t(bytes[0]) + bytes[1] + 1) << 12};
    const Answer answer = answer_of(text);
    judge(answer, asked, nullptr);
    const Origin known{"http://example.org/a", std::uint64_t(1) << 21, "\"1\"", ""};
    judge(answer, asked, &known);
    if (const auto origin = parse_origin(text)) require(parse_origin(text_of(*origin)) == origin);
    try {
        const std::string url = checked_url(text);
        require(shown_url(url).find('\n') == std::string::npos);
    } catch (const Error&) {
    }
    return 0;
}
