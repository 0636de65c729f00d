#include "pipeline/input/photo_matches.h"

#include <gtest/gtest.h>

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// Matches cameras, written as "group:photo", to the photos of folder "/s". If there are several candidates,
/// they are joined by |.
Names matched(const Names& cameras, const Names& photos) {
    std::vector<CameraSet::Entry> entries;
    for (const std::string& name : cameras) {
        const std::size_t colon = name.find(':');
        entries.push_back({.photo = name.substr(colon + 1), .camera = {}, .group = name.substr(0, colon)});
    }
    std::vector<fs::path> files;
    for (const std::string& name : photos) files.push_back("/s/" + name);
    Names out;
    for (const PhotoMatch& m : match_photos("/s", files, entries)) {
        out.push_back(m.file.lexically_relative("/s").string());
        for (const fs::path& c : m.candidates)
            out.back() += (out.back().empty() ? "" : "|") + c.lexically_relative("/s").string();
    }
    return out;
}

TEST(PhotoMatches, GroupsThatAreFoldersTellEqualNamesApart) {
    const Names photos{"1/A.jpg", "1/B.jpg", "2/A.jpg", "2/B.jpg"};
    EXPECT_EQ(matched({"1:A", "2:A", "1:B"}, photos), (Names{"1/A.jpg", "2/A.jpg", "1/B.jpg"}));
    EXPECT_EQ(matched({"2:A"}, photos), Names{"2/A.jpg"}) << "the other camera has no pose";
    EXPECT_EQ(matched({"site/2:A"}, photos), Names{"2/A.jpg"}) << "nested";
    EXPECT_EQ(matched({"Flight 1:A", "Flight 2:B"}, {"1/A.jpg", "1/B.jpg"}), (Names{"1/A.jpg", "1/B.jpg"}));
}

TEST(PhotoMatches, NamesThatFitSeveralPhotosAreNotGuessed) {
    const Names photos{"1/A.jpg", "2/A.jpg", "2/B.jpg"};
    EXPECT_EQ(matched({":A", ":B"}, photos), (Names{"1/A.jpg|2/A.jpg", "2/B.jpg"}));
    EXPECT_EQ(matched({"Flight 1:A.jpg", "Flight 2:A.jpg"}, photos),
              (Names{"1/A.jpg|2/A.jpg", "1/A.jpg|2/A.jpg"}));
    EXPECT_EQ(matched({":A", ":2/A"}, photos), (Names{"1/A.jpg", "2/A.jpg"})) << "only one photo is left";
}

}  // namespace
}  // namespace vantage
