#include "scene/story/story.h"

#include <gtest/gtest.h>

using namespace vantage;

namespace {

const StoryView some_view{{0, 0, 0}, {1, 0, 0}};

}  // namespace

TEST(StoryEdits, TranslatingATextKeepsTheOtherLanguage) {
    Story story;
    StoryText text{"Clock", {}};
    set_text(story, text, "en", "The clock");
    EXPECT_EQ(text, (StoryText{"The clock", {}}));
    set_text(story, text, "de", "Die Uhr");
    EXPECT_EQ(text, (StoryText{"", {{"de", "Die Uhr"}, {"en", "The clock"}}}));
    set_text(story, text, "en", "Clock");
    EXPECT_EQ(text.by_language.at("en"), "Clock");
    EXPECT_EQ(text.by_language.at("de"), "Die Uhr");
}

TEST(StoryEdits, RemovingANoteLeavesNoStopAtIt) {
    Story story;
    story.notes = {{"a", {}, {}, "", some_view, {}}, {"b", {}, {}, "", some_view, {}}};
    story.tours = {{"both", {}, {{"a", {}}, {"b", {}}, {"", some_view}}}, {"one", {}, {{"a", {}}}}};
    story.attract = StoryAttract{60, "one", {}, 0};
    remove_note(story, 0);
    ASSERT_EQ(story.notes.size(), 1u);
    EXPECT_EQ(story.notes[0].id, "b");
    ASSERT_EQ(story.tours.size(), 1u) << "a tour without stops is removed";
    ASSERT_EQ(story.tours[0].stops.size(), 2u);
    EXPECT_EQ(story.tours[0].stops[0].note, "b");
    EXPECT_TRUE(story.tours[0].stops[1].view);
    EXPECT_FALSE(story.attract) << "its tour was removed";
    story.attract = StoryAttract{60, "", {}, 30};
    remove_note(story, 0);
    EXPECT_TRUE(story.attract) << "it does not depend on notes";
    EXPECT_EQ(free_note_id(story), "note-1");
}
