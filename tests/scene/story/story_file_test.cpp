#include "scene/story/story_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/text/error.h"
#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

/// A story with everything that the format supports.
const char* const chapel = R"({
  "format": "vantage-story-1",
  "language": "en",
  "title": {"en": "The chapel", "de": "Die Kapelle"},
  "web": "https://example.org/chapel?from=kiosk",
  "opening": {"eye": [4512340.125, 5345210.5, 2], "target": [4512344, 5345210.5, 1], "fov": 40},
  "background": {"top": "#20262E", "bottom": "#000000", "soft_edges": 0.1},
  "only_object": true,
  "limits": {"near_photos": false, "farthest": 37.5},
  "hidden": [{"center": [4512344, 5345211, 8.5], "radius": 0.25}],
  "notes": [
    {"id": "clock", "title": "The clock", "text": {"en": "Built in 1702.\nIt still runs.", "de": "Von 1702."},
     "picture": "pictures/clock.jpg", "anchor": [4512344, 5345210, 9.5],
     "view": {"eye": [0, 0, 10], "target": [4, 0, 9], "up": [0, 0, 1], "roll": -2.5, "fov": 12}},
    {"id": "door"}
  ],
  "tours": [{"id": "short", "title": "A short tour", "stops": [
    {"note": "clock", "fly": 2, "stay": 8}, {"view": {"eye": [1, 2, 3], "target": [4, 5, 6]}}]}],
  "attract": {"tour": "short", "after": 90}
})";

class StoryFile : public TemporaryFolder {
  protected:
    const std::filesystem::path file = dir / "chapel.story.json";
    void write(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }
    /// The part of the error message after the file name, or "accepted".
    std::string error_of(const std::string& text) const {
        write(text);
        try {
            read_story(file);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), Exit::input);
            const std::string what = e.what();
            EXPECT_TRUE(what.starts_with(file.string() + ": ")) << what;
            EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            return what.substr(file.string().size() + 2);
        }
        return "accepted";
    }
    /// The error for a story that consists of the format and these keys.
    std::string error_with(const std::string& keys) const {
        return error_of(R"({"format": "vantage-story-1", )" + keys + "}");
    }
};

}  // namespace

TEST_F(StoryFile, IsReadAsItIsWritten) {
    write(chapel);
    const auto [story, unknown] = read_story(file);
    EXPECT_TRUE(unknown.empty());
    EXPECT_EQ(text_in(story, story.title, "de"), "Die Kapelle");
    ASSERT_TRUE(story.opening);
    EXPECT_EQ(story.opening->eye, Eigen::Vector3d(4512340.125, 5345210.5, 2));
    EXPECT_EQ(story.opening->fov, 40);
    EXPECT_FALSE(story.opening->up);
    EXPECT_EQ(story.background->top, (StoryColor{0x20, 0x26, 0x2e}));
    EXPECT_EQ(story.background->bottom, (StoryColor{0, 0, 0}));
    EXPECT_EQ(story.background->soft_edges, 0.1);
    EXPECT_TRUE(story.only_object);
    EXPECT_FALSE(story.limits.near_photos);
    EXPECT_EQ(story.limits.farthest, 37.5);
    EXPECT_EQ(story.web, "https://example.org/chapel?from=kiosk");
    EXPECT_EQ(story.hidden, (std::vector{StoryBall{{4512344, 5345211, 8.5}, 0.25}}));
    ASSERT_EQ(story.notes.size(), 2u);
    EXPECT_EQ(story.notes[0].text.by_language.at("en"), "Built in 1702.\nIt still runs.");
    EXPECT_EQ(story.notes[0].picture, "pictures/clock.jpg");
    EXPECT_EQ(story.notes[0].anchor, Eigen::Vector3d(4512344, 5345210, 9.5));
    EXPECT_EQ(story.notes[0].view->roll, -2.5);
    EXPECT_EQ(story.notes[0].view->up, Eigen::Vector3d(0, 0, 1));
    EXPECT_FALSE(story.notes[1].view || story.notes[1].anchor);
    ASSERT_EQ(story.tours[0].stops.size(), 2u);
    EXPECT_EQ(story.tours[0].stops[0].stay, 8);
    EXPECT_EQ(story.tours[0].stops[1].fly, 3) << "the default";
    EXPECT_EQ(story.tours[0].stops[1].view->target, Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(story.attract->after, 90);
    EXPECT_EQ(story.attract->tour, "short");
}

TEST_F(StoryFile, IsWrittenToTheSameBytesAndReadBackTheSame) {
    write(chapel);
    Story story = read_story(file).story;
    story.notes[1].anchor = Eigen::Vector3d(1.0 / 3, 1e-300, -4512344.123456789);
    story.notes[1].title.plain = "quotes \" and \\ and ü and 時計";
    write_story(file, story);
    const std::string once = slurp(file);
    EXPECT_EQ(read_story(file).story, story);
    write_story(file, read_story(file).story);
    EXPECT_EQ(slurp(file), once);
    EXPECT_NE(once.find("\"anchor\": [4512344.0, 5345210.0, 9.5]"), std::string::npos) << once;
    EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

TEST_F(StoryFile, SavesNothingThatCannotBeReadBack) {
    write("mine");
    const auto refused = [&](const Story& story) {
        EXPECT_THROW(write_story(file, story), Error);
        EXPECT_EQ(slurp(file), "mine");
    };
    Story far;
    far.notes.push_back({"a", {}, {}, {}, {}, Eigen::Vector3d(std::nan(""), 0, 0)});
    refused(far);
    far.notes[0].anchor->x() = HUGE_VAL;
    refused(far);
    Story latin;
    latin.title.plain =
        "Br\xfc"
        "cke";
    refused(latin);
    Story twice;
    twice.notes = {{"a", {}, {}}, {"a", {}, {}}};
    refused(twice);
    EXPECT_THROW(write_story(dir / "missing" / "a.story.json", Story{}), Error);
}

TEST_F(StoryFile, ErrorsNameThePlaceWhatWasFoundAndWhatWasExpected) {
    EXPECT_EQ(error_of("{}"), "format: is missing");
    EXPECT_EQ(error_of(R"({"format": "vantage-story-2"})"),
              "format: found \"vantage-story-2\", expected \"vantage-story-1\"");
    EXPECT_EQ(error_of("[1, 2]"),
              "found an array of 2, expected an object with format, language, title, web, opening, "
              "background, only_object, limits, hidden, notes, tours, attract");
    EXPECT_EQ(error_with(R"("opening": {"eye": [0, 0, 0], "target": [1, 0, 0], "fov": 200})"),
              "opening.fov: found 200, expected a number from 0.02 to 178");
    EXPECT_EQ(error_with(R"("opening": {"eye": [0, 0, 0], "target": [1, 0]})"),
              "opening.target: found an array of 2, expected three numbers, such as [1, 0, 0.5]");
    EXPECT_EQ(error_with(R"("opening": {"eye": [0, 0, 0]})"), "opening.target: is missing");
    EXPECT_EQ(error_with(R"("opening": {"eye": [2, 0, 0], "target": [2, 0, 0]})"),
              "opening: found an object, expected a target that differs from the eye");
    EXPECT_EQ(error_with(R"("notes": [{"id": "a"}, {"id": "b", "anchor": [0, "1", 2]}])"),
              "notes[1].anchor[1]: found \"1\", expected a number from -1e+12 to 1e+12");
    EXPECT_EQ(error_with(R"("notes": [{"id": "a"}, {"id": "a"}])"),
              "notes[1].id: found \"a\", expected a unique id");
    EXPECT_EQ(error_with(R"("notes": [{"id": "the clock"}])"),
              "notes[0].id: found \"the clock\", expected an id that consists of letters, digits, '-', '_' "
              "and '.'");
    EXPECT_EQ(error_with(R"("tours": [{"id": "a", "stops": [{"fly": 1}]}])"),
              "tours[0].stops[0]: found an object, expected either a note or a view");
    EXPECT_EQ(error_with(R"("background": {"top": "#000000"})"),
              "background: found an object, expected either color, or top and bottom");
    EXPECT_EQ(error_with(R"("background": {"color": "black"})"),
              "background.color: found \"black\", expected a color, such as \"#20262e\"");
    EXPECT_EQ(error_with(R"("limits": {"near_photos": "yes"})"),
              "limits.near_photos: found \"yes\", expected true or false");
    EXPECT_EQ(error_with(R"("limits": {"farthest": 0})"),
              "limits.farthest: found 0, expected a number from 1e-06 to 1e+12");
    EXPECT_EQ(error_with(R"("web": "ftp://example.org")"),
              "web: found \"ftp://example.org\", expected an address that begins with https:// or http://");
    EXPECT_EQ(error_with(R"("hidden": [{"center": [0, 0, 0], "radius": 0}])"),
              "hidden[0].radius: found 0, expected a number from 1e-12 to 1e+12");
    EXPECT_EQ(error_with(R"("attract": {"tour": "a", "turn": 30})"),
              "attract: found an object, expected one of tour, stops and turn");
    EXPECT_EQ(error_with(R"("title": {"english": "x", "e": "y"})"),
              "title[\"e\"]: found \"y\", expected a language, such as \"en\" or \"pt-BR\"");
    EXPECT_EQ(error_with(R"("title": 7)"),
              "title: found 7, expected a string, or an object with a string for each language");
}

TEST_F(StoryFile, APasserBysFileDoesNoHarm) {
    EXPECT_NE(error_of(std::string(100000, '[')).find("nested"), std::string::npos);
    EXPECT_NE(error_of(std::string(9 << 20, ' ')).find("8 MiB"), std::string::npos);
    EXPECT_NE(error_of("").find("is not JSON"), std::string::npos);
    EXPECT_NE(error_of(std::string(chapel).substr(0, 300)).find("line"), std::string::npos);
    EXPECT_NE(error_with(R"("opening": {"eye": [1e999, 0, 0], "target": [1, 0, 0]})"), "accepted");
    EXPECT_NE(error_with(R"("opening": {"eye": [NaN, 0, 0], "target": [1, 0, 0]})"), "accepted");
    EXPECT_NE(error_with(R"("opening": {"eye": [1e13, 0, 0], "target": [1, 0, 0]})"), "accepted");
    EXPECT_NE(error_with("\"title\": \"Br\xfc"
                         "cke\""),
              "accepted")
        << "not UTF-8";
    EXPECT_NE(error_with(R"("title": "a\u0000b")"), "accepted");
    EXPECT_NE(error_with(R"("title": ")" + std::string(501, 'a') + '"'), "accepted");
    EXPECT_NE(error_with(R"("language": "en", "language": "de")").find("twice"), std::string::npos);
    for (const char* picture :
         {"/etc/passwd.png", "../x.png", "a/../../x.png", "http://a.b/x.png", "x.svg", ""})
        EXPECT_NE(error_with(R"("notes": [{"id": "a", "picture": ")" + std::string(picture) + "\"}]"),
                  "accepted")
            << picture;
    std::string many = R"("notes": [)";
    for (int i = 0; i <= 1000; ++i) many += (i ? ",{\"id\":\"" : "{\"id\":\"") + std::to_string(i) + "\"}";
    EXPECT_EQ(error_with(many + "]"),
              "notes: found an array of 1001, expected an array of at most 1000 items");
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
    EXPECT_THROW(read_story(file), Error);
}

TEST_F(StoryFile, UnknownKeysAreReportedAndIgnored) {
    write(R"({"format": "vantage-story-1", "author": "me", "notes": [{"id": "a", "titel": "x"}]})");
    const auto [story, unknown] = read_story(file);
    EXPECT_EQ(story.notes.size(), 1u);
    ASSERT_EQ(unknown.size(), 2u);
    EXPECT_TRUE(unknown[0].starts_with("unknown key \"author\", expected format, ")) << unknown[0];
    EXPECT_EQ(unknown[1], "notes[0]: unknown key \"titel\", expected id, title, text, picture, view, anchor");
}

TEST(StoryFileName, IsBesideThePackage) {
    EXPECT_EQ(story_file_of("collection/chapel.vantage"), "collection/chapel.story.json");
    EXPECT_EQ(story_file_of("church.v2.toml"), "church.v2.story.json");
    EXPECT_EQ(story_file_of("https://museum.org/chapel.vantage"), "");
}

TEST(Story, TextsAreShownInTheVisitorsLanguageOrTheNextBest) {
    Story story;
    story.language = "fr";
    const StoryText several{"", {{"de", "Uhr"}, {"fr", "horloge"}, {"pt-BR", "relógio"}}}, one{"clock", {}};
    EXPECT_EQ(text_in(story, several, "de"), "Uhr");
    EXPECT_EQ(text_in(story, several, "de-AT"), "Uhr");
    EXPECT_EQ(text_in(story, several, "pt-BR"), "relógio");
    EXPECT_EQ(text_in(story, several, "nl"), "horloge");
    EXPECT_EQ(text_in(story, one, "de"), "clock");
    story.language = "en";
    EXPECT_EQ(text_in(story, several, "nl"), "Uhr") << "no English text";
    story.title = several;
    EXPECT_EQ(languages_of(story), (std::vector<std::string>{"de", "en", "fr", "pt-BR"}));
}
