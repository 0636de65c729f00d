#include "player/tour/story_views.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/text/error.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

/// The scene is far from the input's origin, as is common for surveys.
const InputAxes far_axes{Vector3d(4512340, 5345210, 120), Vector3d::UnitZ()};

}  // namespace

TEST(StoryViews, AreInTheInputsCoordinatesAndTurnClockwise) {
    StoryView view{{4512340, 5345200, 122}, {4512340, 5345210, 122}};
    view.fov = 35;
    const Navigation level = camera_at(view, far_axes);
    EXPECT_EQ(level.eye, Vector3d(0, -10, 2));
    EXPECT_EQ(level.target, Vector3d(0, 0, 2));
    EXPECT_EQ(level.fov, 35);
    // The camera looks along +y with z up, so +x points right and -z down.
    EXPECT_LT((level.R.row(0).transpose() - Vector3d(1, 0, 0)).norm(), 1e-12);
    EXPECT_LT((level.R.row(1).transpose() - Vector3d(0, 0, -1)).norm(), 1e-12);
    EXPECT_LT((level.R.row(2).transpose() - Vector3d(0, 1, 0)).norm(), 1e-12);
    view.roll = 90;  // the camera's right side points down
    EXPECT_LT((camera_at(view, far_axes).R.row(0).transpose() - Vector3d(0, 0, -1)).norm(), 1e-12);
    view.roll = 0;
    view.up = Vector3d(2, 0, 0);  // the top of the camera is where x is
    EXPECT_LT((camera_at(view, far_axes).R.row(1).transpose() - Vector3d(-1, 0, 0)).norm(), 1e-12);
}

TEST(StoryViews, AreWrittenInFewDigitsAndReadBackAsTheSameCamera) {
    StoryView view{{4512341.5, 5345198.25, 123.125}, {4512339.75, 5345210, 121}};
    view.roll = -7.5;
    view.fov = 50;
    const StoryView again = story_view(camera_at(view, far_axes), far_axes);
    EXPECT_LT((again.eye - view.eye).norm(), 2e-5);
    EXPECT_LT((again.target - view.target).norm(), 2e-5);
    EXPECT_EQ(again.roll, -7.5);
    EXPECT_EQ(again.fov, 50);
    EXPECT_FALSE(again.up);
    // At a distance of 12, five decimals are stored.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(again.eye[i] * 1e5, std::round(again.eye[i] * 1e5), 2e-3);
    view.up = Vector3d(0, 0.6, 0.8);
    const Navigation camera = camera_at(view, far_axes);
    const StoryView tilted = story_view(camera, far_axes);
    ASSERT_TRUE(tilted.up);
    EXPECT_LT((camera_at(tilted, far_axes).R - camera.R).norm(), 1e-5);
}

TEST(StoryTours, TakeTheirTimesFromTheStops) {
    Story story;
    story.notes = {{"clock", {}, {}, "", StoryView{{1, 0, 0}, {0, 0, 0}}, {}}, {"door", {}, {}}};
    const StoryView view{{0, 1, 0}, {0, 0, 0}};
    const std::vector<StoryStop> stops{{"clock", {}, 2, 5}, {"", view, 3, 0}};
    const InputAxes here{Vector3d::Zero(), Vector3d::UnitZ()};
    const auto times = [](const std::vector<KeyView>& keys) {
        std::vector<double> out;
        for (const KeyView& k : keys) out.push_back(k.seconds);
        return out;
    };
    const auto alone = keys_of(story, stops, {}, here, "a.story.json");
    EXPECT_EQ(times(alone), (std::vector<double>{0, 5, 8}));
    EXPECT_EQ(alone[1].camera.eye, Vector3d(1, 0, 0));
    EXPECT_EQ(alone[2].camera.eye, Vector3d(0, 1, 0));
    const auto from = keys_of(story, stops, camera_at({{9, 9, 9}, {0, 0, 0}}, here), here, "a.story.json");
    EXPECT_EQ(times(from), (std::vector<double>{0, 2, 7, 10}));
    EXPECT_THROW(keys_of(story, {{"door", {}}}, {}, here, "a.story.json"), Error);
}
