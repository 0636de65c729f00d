#include "scene/remote/origin.h"

#include <gtest/gtest.h>

namespace vantage {

namespace {

const Origin origin{"https://host/scan.vantage", 1000, "\"5f-1\"", "Mon, 01 Jan 2024 00:00:00 GMT"};

}  // namespace

TEST(Origin, IsReadAsWritten) {
    EXPECT_EQ(parse_origin(text_of(origin)), origin);
    EXPECT_EQ(parse_origin(text_of({"http://a/b", 1, "", "today"})), (Origin{"http://a/b", 1, "", "today"}));
}

TEST(Origin, IsRefusedIfCutAnywhere) {
    const std::string text = text_of(origin);
    for (std::size_t length = 0; length < text.size(); ++length)
        EXPECT_FALSE(parse_origin(text.substr(0, length))) << length;
    EXPECT_FALSE(parse_origin(text + "more"));
}

TEST(Origin, IsRefusedIfAValueIsOutOfRange) {
    const auto changed = [](Origin o) { return parse_origin(text_of(o)).has_value(); };
    EXPECT_FALSE(changed({origin.url, 0, origin.etag, ""}));
    EXPECT_TRUE(changed({origin.url, largest_remote_file, origin.etag, ""}));
    EXPECT_FALSE(changed({origin.url, largest_remote_file + 1, origin.etag, ""}));
    EXPECT_FALSE(changed({origin.url, 1, "", ""}));
    EXPECT_FALSE(changed({"", 1, origin.etag, ""}));
    std::string text = text_of(origin);
    text.replace(text.find("size 1000"), 9, "size -100");
    EXPECT_FALSE(parse_origin(text));
}

TEST(Origin, OfAnotherFormatIsOursButNotRead) {
    std::string text = text_of(origin);
    text.replace(text.find(" 1\n"), 3, " 2\n");
    EXPECT_TRUE(begins_like_origin(text));
    EXPECT_FALSE(parse_origin(text));
    EXPECT_FALSE(begins_like_origin("[remote \"origin\"]"));
}

TEST(Origin, IsTheSameVersionByETagOrElseByDate) {
    EXPECT_TRUE(same_version(origin, {"", 1000, origin.etag, "another day"}));
    EXPECT_FALSE(same_version(origin, {"", 1000, "\"other\"", origin.last_modified}));
    EXPECT_FALSE(same_version(origin, {"", 1001, origin.etag, origin.last_modified}));
    EXPECT_TRUE(same_version(origin, {"", 1000, "", origin.last_modified}));
    EXPECT_FALSE(same_version({"", 5, "", ""}, {"", 5, "", ""}));
}

}  // namespace vantage
