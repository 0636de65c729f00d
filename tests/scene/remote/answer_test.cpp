#include "scene/remote/answer.h"

#include <gtest/gtest.h>

namespace vantage {

namespace {

Answer answer_of(std::initializer_list<const char*> lines) {
    Answer answer;
    for (const char* line : lines) take_header_line(answer, line);
    return answer;
}

}  // namespace

TEST(Answer, IsReadFromItsHeaders) {
    const Answer answer =
        answer_of({"HTTP/2 206\r\n", "CONTENT-RANGE:bytes 0-9/20\r\n", "content-length:  10 \r\n",
                   "ETag: \"a:b\"\r\n", "Last-Modified: today\r\n", "\r\n"});
    EXPECT_EQ(answer.status, 206);
    EXPECT_EQ(answer.content_range->total, 20);
    EXPECT_EQ(answer.content_length, 10);
    EXPECT_EQ(answer.etag, "\"a:b\"");
    EXPECT_EQ(answer.last_modified, "today");
    EXPECT_EQ(flaw_of(answer, {0, 10}, nullptr), "");
}

TEST(Answer, StartsAnewAfterARedirect) {
    const Answer answer =
        answer_of({"HTTP/1.1 302 Found", "ETag: \"a\"", "Location: /b", "", "HTTP/1.1 206 Partial"});
    EXPECT_EQ(answer.status, 206);
    EXPECT_EQ(answer.etag, "");
    EXPECT_EQ(answer.location, "");
}

TEST(Answer, HasNoWeakETag) { EXPECT_EQ(answer_of({"HTTP/1.1 206 X", "ETag: W/\"a\""}).etag, ""); }

TEST(Answer, IsReportedInOneShortLine) {
    const Answer answer = answer_of({"HTTP/1.1 206 X", "Content-Encoding: a\x1b[2J\rb"});
    EXPECT_EQ(flaw_of(answer, {0, 1}, nullptr),
              "the response has the Content-Encoding 'a?[2J?b', expected identity");
    const std::string encoding = "Content-Encoding: " + std::string(10'000, 'x');
    EXPECT_LT(flaw_of(answer_of({"HTTP/1.1 206 X", encoding.c_str()}), {0, 1}, nullptr).size(), 200);
}

TEST(Answer, SurvivesMalformedLines) {
    for (const char* line :
         {"", ":", "HTTP/", "HTTP/1.1", "HTTP/1.1 ", "HTTP/1.1 abc", "HTTP/1.1 99", "no colon"})
        EXPECT_EQ(answer_of({line}).status, 0) << line;
    EXPECT_FALSE(answer_of({"HTTP/1.1 206 X", "Content-Length: -1"}).content_length);
}

TEST(Answer, MayBeShorterThanTheFirstRequestOnlyAtTheEndOfTheFile) {
    Answer answer = answer_of({"HTTP/1.1 206 X", "ETag: \"a\"", "Content-Range: bytes 0-19/20"});
    EXPECT_EQ(flaw_of(answer, {0, 100}, nullptr), "");
    EXPECT_EQ(origin_of(answer, "u"), (Origin{"u", 20, "\"a\"", ""}));
    take_header_line(answer, "Content-Range: bytes 0-18/20");
    EXPECT_EQ(flaw_of(answer, {0, 100}, nullptr), "the server sends bytes 0 to 18, expected bytes 0 to 19");
}

}  // namespace vantage
