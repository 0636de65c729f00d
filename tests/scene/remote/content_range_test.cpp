#include "scene/remote/content_range.h"

#include <gtest/gtest.h>

namespace vantage {

TEST(ContentRange, GivesTheRangeAndTheTotal) {
    const auto range = parse_content_range("bytes 100-199/1000");
    ASSERT_TRUE(range);
    EXPECT_EQ(range->bytes, (ByteRange{100, 200}));
    EXPECT_EQ(range->total, 1000);
}

TEST(ContentRange, MayLackTheRangeOrTheTotal) {
    EXPECT_EQ(parse_content_range("bytes */1000")->bytes, std::nullopt);
    EXPECT_EQ(parse_content_range("bytes */1000")->total, 1000);
    EXPECT_EQ(parse_content_range("BYTES 0-0/*")->total, std::nullopt);
    EXPECT_EQ(parse_content_range("bytes 0-0/*")->bytes, (ByteRange{0, 1}));
}

TEST(ContentRange, IsRefusedIfMalformed) {
    for (const char* text :
         {"", "bytes", "bytes ", "bytes 0-9", "bytes 0-9/", "bytes /10", "bytes 0/10", "bytes -9/10",
          "bytes 0-/10", "bytes 0-9/10 ", "bytes  0-9/10", "bytes 0-9/10,", "items 0-9/10", "bytes=0-9/10",
          "bytes 0x0-9/10", "bytes +0-9/10", "bytes 0-9/-10", "bytes */*", "bytes 0-9/10/10"})
        EXPECT_FALSE(parse_content_range(text)) << text;
}

TEST(ContentRange, IsRefusedIfItContradictsItself) {
    EXPECT_FALSE(parse_content_range("bytes 9-3/20"));
    EXPECT_FALSE(parse_content_range("bytes 0-20/20"));
    EXPECT_TRUE(parse_content_range("bytes 0-19/20"));
}

TEST(ContentRange, IsRefusedBeyond64Bits) {
    EXPECT_TRUE(parse_content_range("bytes 0-9/18446744073709551615"));
    EXPECT_FALSE(parse_content_range("bytes 0-9/18446744073709551616"));
    EXPECT_FALSE(parse_content_range("bytes 0-18446744073709551615/*"));
}

}  // namespace vantage
