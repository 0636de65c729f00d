#include "base/files/shell_word.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace vantage {
namespace {

TEST(ShellWord, IsReadByAShellAsTheText) {
    for (const std::string text :
         {"", "plain/name-1.vantage", "a b", "it's", "$HOME", "-o", "\"", "*", "a\\b", "é"}) {
        FILE* const shell = ::popen(("printf %s -- " + shell_word(text)).c_str(), "r");
        std::array<char, 100> read{};
        const std::size_t n = std::fread(read.data(), 1, read.size(), shell);
        ::pclose(shell);
        EXPECT_EQ(std::string(read.data(), n), "--" + text);
    }
}

TEST(ShellWord, PlainNamesStayReadable) {
    EXPECT_EQ(shell_word("scans/chapel-2.vantage"), "scans/chapel-2.vantage");
}

}  // namespace
}  // namespace vantage
