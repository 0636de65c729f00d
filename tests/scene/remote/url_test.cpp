#include "scene/remote/url.h"

#include <gtest/gtest.h>

#include "base/text/error.h"
#include "base/text/is_url.h"

namespace vantage {

TEST(Url, IsHttpOrHttps) {
    for (const char* text : {"http://host/a", "https://host/a", "HTTPS://host"})
        EXPECT_TRUE(is_url(text)) << text;
    for (const char* text :
         {"", "scan.vantage", "/a/http://b", "http:", "https://", "ftp://host/a", "file:///a"})
        EXPECT_FALSE(is_url(text)) << text;
}

TEST(Url, IsCheckedAndLosesItsFragment) {
    EXPECT_EQ(checked_url("https://host/a?b=c#part"), "https://host/a?b=c");
    for (const char* text : {"scan.vantage", "https://host/a b", "https://host:port/a", "https://host/a\nb"})
        EXPECT_THROW(checked_url(text), Error) << text;
}

TEST(Url, IsShownWithoutPassword) {
    EXPECT_EQ(shown_url("https://me:secret@host:8443/a?b=c"), "https://host:8443/a?b=c");
}

}  // namespace vantage
