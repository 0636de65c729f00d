#include "scene/story/story_references.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/temporary_folder.h"

using namespace vantage;

namespace {

using StoryReferences = TemporaryFolder;
const StoryView view{{0, 0, 0}, {1, 0, 0}};

}  // namespace

TEST(StoryStops, MustNameNotesWithAView) {
    Story story;
    story.notes = {{"clock", {}, {}, "", view, {}}, {"door", {}, {}}};
    story.tours = {{"short", {}, {{"clock", {}}, {"", view}, {"door", {}}, {"clcok", {}}}}};
    story.attract = StoryAttract{60, "long", {}, 0};
    const std::vector<std::string> found = dangling_references(story);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0], "tours[0].stops[2].note: found \"door\", expected a note that has a view");
    EXPECT_EQ(found[1], "tours[0].stops[3].note: found \"clcok\", expected the id of a note");
    EXPECT_EQ(found[2], "attract.tour: found \"long\", expected the id of a tour");
    story.attract->tour = "short";
    story.tours[0].stops.resize(2);
    EXPECT_TRUE(dangling_references(story).empty());
}

TEST_F(StoryReferences, PicturesAreLookedForBesideTheStory) {
    Story story;
    for (const char* name : {"whole.png", "gone.png", "text.jpg", "photo.JPG"})
        story.notes.push_back({name, {}, {}, name});
    std::ofstream(dir / "whole.png") << "\x89PNG\r\n\x1a\n and more";
    std::ofstream(dir / "text.jpg") << "a text";
    std::ofstream(dir / "photo.JPG") << "\xff\xd8\xff\xe0";
    EXPECT_EQ(missing_pictures(story, dir),
              (std::vector<std::string>{"notes[1].picture: gone.png does not exist",
                                        "notes[2].picture: text.jpg is not a PNG or JPEG file"}));
}

TEST(StoryAnchors, MayLieATenthOfTheDiagonalOutside) {
    Story story;
    const Eigen::AlignedBox3d box(Eigen::Vector3d(100, 0, 0), Eigen::Vector3d(102, 2, 1));  // diagonal 3
    for (const double x : {101.0, 102.2, 102.5, 99.5})
        story.notes.push_back({std::to_string(x), {}, {}, "", {}, Eigen::Vector3d(x, 1, 1)});
    const std::vector<std::string> found = anchors_outside(story, box);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], "notes[2].anchor: is 0.5 outside the model, expected a point on it");
    EXPECT_TRUE(found[1].starts_with("notes[3].anchor")) << found[1];
}
