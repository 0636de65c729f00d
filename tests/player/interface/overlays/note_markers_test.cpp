#include "player/interface/overlays/note_markers.h"

#include <gtest/gtest.h>

#include "player/interface/overlays/surface_at_pixel.h"

using namespace vantage;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// A view from (0, -10, 0) along +y, of 400 x 300 pixels with a focal length of 500: x points right, z up.
View view() {
    View v{{400, 300, 500, 500, 200, 150}, {}};
    v.cam_from_origin.R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    v.cam_from_origin.t = -v.cam_from_origin.R * Vector3d(0, -10, 0);
    return v;
}
const InputAxes note_axes{Vector3d(1000, 2000, 3000), Vector3d::UnitZ()};

Story story_with(const std::vector<Vector3d>& anchors) {
    Story story;
    for (const Vector3d& a : anchors) story.notes.push_back({free_note_id(story), {}, {}, "", {}, a});
    story.notes.push_back({"no anchor", {}, {}});
    return story;
}

}  // namespace

TEST(NoteMarkers, AreWhereTheAnchorsProject) {
    const Story story = story_with({{1002, 2000, 3001},    // 10 ahead, 2 to the right, 1 up
                                    {1000, 2040, 3000},    // 50 ahead
                                    {1000, 1980, 3000},    // behind the viewer
                                    {1009, 2000, 3000}});  // beside the frame
    const auto nothing = [](const Vector2d&) { return std::optional<Vector3d>(); };
    const std::vector<NoteMarker> markers = note_markers(story, note_axes, view(), nothing);
    ASSERT_EQ(markers.size(), 2u);
    EXPECT_EQ(markers[0].note, 1u) << "the farthest note is drawn first";
    EXPECT_LT((markers[0].at - Vector2d(200, 150)).norm(), 1e-9);
    EXPECT_LT((markers[1].at - Vector2d(200 + 500 * 0.2, 150 - 500 * 0.1)).norm(), 1e-9);
    EXPECT_NEAR(markers[1].depth, 10, 1e-9);
    EXPECT_FALSE(markers[0].hidden || markers[1].hidden);
}

TEST(NoteMarkers, AreHiddenByANearerSurfaceOnly) {
    const Story story = story_with({{1000, 2000, 3000}});
    for (const View& from : {view(), orthographic(view(), 10, 10)}) {
        const auto hidden_by = [&](double y) {
            const auto surface = [&](const Vector2d& at) {
                EXPECT_LT((at - Vector2d(200, 150)).norm(), 1e-6);
                return std::optional(Vector3d(0, y, 0));
            };
            return note_markers(story, note_axes, from, surface).at(0).hidden;
        };
        EXPECT_FALSE(hidden_by(0)) << "its own surface";
        EXPECT_FALSE(hidden_by(-0.05));
        EXPECT_TRUE(hidden_by(-0.2));
        EXPECT_FALSE(hidden_by(5)) << "a surface behind it";
    }
}

TEST(NoteMarkers, AreMissingWhereTheStoryHidesTheSurface) {
    Story story = story_with({{1000, 2000, 3000}});
    const auto shown_at = [&](double y) {
        const auto surface = [&](const Vector2d&) { return std::optional(Vector3d(0, y, 0)); };
        return note_markers(story, note_axes, view(), surface).size();
    };
    EXPECT_EQ(shown_at(5), 1u);
    story.hidden.push_back({{1000, 2000, 3000.5}, 0.6});
    EXPECT_EQ(shown_at(5), 0u);
    EXPECT_EQ(shown_at(0), 1u) << "this part of the ball's surface remained";
}

TEST(SurfaceAtPixel, IsOnTheTriangleThatIsSeenThere) {
    PlanScene scene;
    const std::vector<Eigen::Vector3f> corners{{-1, 0, -1}, {1, 0, -1}, {0, 2, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    scene.positions = corners;
    scene.indices = indices;
    scene.triangles = 1;
    // At half the frame's size: all pixels on the left show the triangle, and those on the right show
    // nothing.
    std::vector<std::uint32_t> numbers(200 * 150, 0);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i % 200 < 110 ? 1 : 0;
    const View from = view();
    const auto numbers_seen = std::make_shared<std::vector<std::uint32_t>>(numbers);
    const SeenTriangles seen{numbers_seen, from, 1};
    // The triangle's plane rises from z = -1 at y = 0 with slope 1, so the view axis meets the plane at y =
    // 1.
    const auto middle = surface_at_pixel(scene, seen, {200, 150});
    ASSERT_TRUE(middle);
    EXPECT_LT((*middle - Vector3d(0, 1, 0)).norm(), 1e-6);
    EXPECT_FALSE(surface_at_pixel(scene, seen, {300, 150}));
    EXPECT_FALSE(surface_at_pixel(scene, seen, {-1, 150}));
    EXPECT_FALSE(surface_at_pixel(scene, seen, {400, 150}));
    EXPECT_FALSE(surface_at_pixel(scene, SeenTriangles{{}, from, 0}, {200, 150}));
    for (std::uint32_t& n : *numbers_seen) n = 7;  // no such triangle
    EXPECT_FALSE(surface_at_pixel(scene, seen, {200, 150}));
}
