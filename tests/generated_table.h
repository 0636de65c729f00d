#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace vantage {

/// Expects the rows of a table in a document to equal `rows`, which come from a program. The table follows
/// the line "<!-- NAME: VANTAGE_WRITE_DOCS=1 writes the rows -->". If that variable is set, writes the rows
/// into the document instead.
inline void expect_table(const std::filesystem::path& document, const std::string& name,
                         const std::string& rows) {
    std::stringstream text;
    text << std::ifstream(document).rdbuf();
    const std::string all = text.str(),
                      mark = "<!-- " + name + ": VANTAGE_WRITE_DOCS=1 writes the rows -->\n";
    const std::size_t marked = all.find(mark);
    ASSERT_NE(marked, all.npos) << document << " lacks " << mark;
    const std::size_t heading = all.find("|---", marked), begin = all.find('\n', heading) + 1;
    std::size_t end = begin;
    while (end < all.size() && all[end] == '|') end = all.find('\n', end) + 1;
    if (std::getenv("VANTAGE_WRITE_DOCS"))
        std::ofstream(document) << all.substr(0, begin) << rows << all.substr(end);
    else
        EXPECT_EQ(all.substr(begin, end - begin), rows)
            << document << ": to update it, run this test with VANTAGE_WRITE_DOCS=1";
}

}  // namespace vantage
