#include "base/text/photo_names.h"

#include <gtest/gtest.h>

#include <array>

namespace vantage {
namespace {

using Indices = std::vector<std::size_t>;

TEST(PhotoNames, AreMeantAsPeopleCallThem) {
    // The first name is in decomposed Unicode, as on macOS.
    const std::array<std::string_view, 4> names{
        "Kapelle Su\xcc\x88"
        "d.jpg",
        "0003.JPG", "b.jpg", "b.png"};
    EXPECT_EQ(photos_meant(names,
                           "Kapelle S\xc3\xbc"
                           "d.jpg"),
              Indices{0})
        << "composed, as typed";
    EXPECT_EQ(photos_meant(names,
                           "Kapelle S\xc3\xbc"
                           "d"),
              Indices{0});
    EXPECT_EQ(photos_meant(names,
                           "kapelle s\xc3\xbc"
                           "d"),
              Indices{0});
    EXPECT_EQ(photos_meant(names, "0003"), Indices{1});
    EXPECT_EQ(photos_meant(names, "0003.jpg"), Indices{1});
    EXPECT_EQ(photos_meant(names, "b.png"), Indices{3}) << "an exact match wins";
    EXPECT_EQ(photos_meant(names, "b"), (Indices{2, 3})) << "ambiguous";
    EXPECT_TRUE(photos_meant(names, "c").empty());
}

}  // namespace
}  // namespace vantage
