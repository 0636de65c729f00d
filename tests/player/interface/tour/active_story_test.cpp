#include "player/interface/tour/active_story.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/text/error.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

class ActiveStories : public TemporaryFolder {
  protected:
    const std::filesystem::path file = dir / "a.story.json";
    void write(const std::string& text) const { std::ofstream(file) << text; }
    ActiveStory active() const {
        return active_story(dir / "a.vantage", {Vector3d::Zero(), Vector3d::UnitZ()}, "de-AT");
    }
    WindowState window;
    Session session() {
        Session s(window);
        const Vector3d eye(0, -10, 0), target(0, 0, 0), up(0, 0, 1);
        s.viewpoint.camera = {eye, target, up, view_towards(eye, target, up, 45, 1, 1).cam_from_origin.R, 45};
        return s;
    }
};

const char* const two_stops = R"({"format": "vantage-story-1", "notes": [
  {"id": "a", "view": {"eye": [10, 0, 0], "target": [0, 0, 0]}},
  {"id": "b", "view": {"eye": [0, 10, 0], "target": [0, 0, 0]}}],
  "tours": [{"id": "t", "stops": [{"note": "a", "fly": 2, "stay": 3}, {"note": "b", "fly": 1, "stay": 4}]}]})";

}  // namespace

TEST_F(ActiveStories, ToursFlyToEachStopAndShowItsCardWhileTheyStay) {
    write(two_stops);
    ActiveStory story = active();
    Session s = session();
    play_tour(story, s, 0, 100);
    const auto at = [&](double now) {
        continue_flight(s.viewpoint, now);
        continue_tour(story, s.viewpoint, now);
    };
    at(101);
    EXPECT_FALSE(story.open) << "on the way";
    EXPECT_NEAR(s.viewpoint.camera.eye.norm(), 10, 0.1) << "around the model";
    at(103);
    EXPECT_EQ(story.open, 0u);
    EXPECT_LT((s.viewpoint.camera.eye - Vector3d(10, 0, 0)).norm(), 1e-6);
    at(105.5);
    EXPECT_FALSE(story.open) << "on the way";
    at(107);
    EXPECT_EQ(story.open, 1u);
    EXPECT_LT((s.viewpoint.camera.eye - Vector3d(0, 10, 0)).norm(), 1e-6);
    at(111);
    EXPECT_FALSE(s.viewpoint.flight);
    EXPECT_FALSE(story.playing);
    EXPECT_LT((s.viewpoint.camera.eye - Vector3d(0, 10, 0)).norm(), 1e-6);
}

TEST_F(ActiveStories, AStopLastsFromTheFinalPictureOn) {
    write(two_stops);
    ActiveStory story = active();
    Session s = session();
    play_tour(story, s, 0, 100);
    const auto at = [&](double now, bool final) {
        continue_flight(s.viewpoint, now, final);
        continue_tour(story, s.viewpoint, now);
    };
    for (const double now : {101.0, 101.9, 102.1}) at(now, false);  // arrives after 2 seconds
    const auto camera = s.viewpoint.camera;
    at(110, false);
    EXPECT_EQ(s.viewpoint.camera.eye, camera.eye);
    at(112.5, true);
    EXPECT_EQ(s.viewpoint.camera.eye, camera.eye) << "stays for 3 seconds after the final picture";
    EXPECT_EQ(s.viewpoint.camera.R, camera.R) << "without any motion, so that the picture is refined";
    EXPECT_EQ(story.open, 0u);
    at(113.5, true);
    EXPECT_FALSE(story.open) << "on the way";
    for (double now = 114; now < 140; now += 0.5) at(now, false);
    EXPECT_FALSE(story.playing) << "no stop waits for longer than 15 seconds";
}

TEST_F(ActiveStories, InputEndsATour) {
    write(two_stops);
    ActiveStory story = active();
    Session s = session();
    play_tour(story, s, 0, 0);
    continue_flight(s.viewpoint, 1);
    s.viewpoint.flight.reset();  // as dragging does
    continue_tour(story, s.viewpoint, 1);
    EXPECT_FALSE(story.playing);
    continue_flight(s.viewpoint, 3);
    continue_tour(story, s.viewpoint, 3);
    EXPECT_FALSE(story.open);
}

TEST_F(ActiveStories, AStoryThatAnotherProgramChangedIsNotReplaced) {
    ActiveStory story = active();
    EXPECT_TRUE(story.trouble.empty());
    story.story.notes.push_back({"a", {"Clock", {}}, {}});
    save(story);
    EXPECT_NE(slurp(file).find("\"Clock\""), std::string::npos);
    story.story.notes[0].title.plain = "Door";
    save(story);
    write("{}");
    EXPECT_THROW(save(story), Error);
    EXPECT_EQ(slurp(file), "{}");
}

TEST_F(ActiveStories, WhatCannotBeReadIsSaid) {
    write("{");
    const ActiveStory story = active();
    EXPECT_NE(story.trouble.find(file.string()), std::string::npos);
    EXPECT_FALSE(story.any());
    write(R"({"format": "vantage-story-1", "mood": 1, "notes": [{"id": "a"}]})");
    EXPECT_TRUE(active().any());
    EXPECT_NE(active().trouble.find("mood"), std::string::npos)
        << "an unknown key would be lost if the story were saved";
    EXPECT_TRUE(active_story("https://a.org/a.vantage", {}, "").file.empty());
}
