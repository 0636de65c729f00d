// Changes are reset, undone and redone.
#include <algorithm>
#include <array>

#include "player/survey/survey_file.h"
#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;
using Eigen::Vector3d;

namespace {

class WindowUndo : public WindowTest {
  protected:
    static bool shows(const std::string& text) { return shown_text().find(text) != std::string::npos; }
    static void click(HeadlessWindow& w, const Vector3d& place) {
        const Vector3d origin = Eigen::Map<const Vector3d>(w.package().scene().origin);
        w.wait(1);  // no double click
        w.point_at(project(w.view().intrinsics, w.view().cam_from_origin, place - origin)->pixel);
        w.frames();
        w.click();
    }
};

}  // namespace

TEST_F(WindowUndo, GoesBackThroughSettingsCutsMeasurementsAndNotesAndForthAgain) {
    ShowOptions options;
    options.package.photos = {"0002.jpg"};
    HeadlessWindow w(copy_of(WindowScene::tiny), options);
    w.resize(1400, 900);
    const auto undo = [&] { w.key(GLFW_KEY_Z, control); };
    const auto redo = [&] { w.key(GLFW_KEY_Y, control); };
    undo();
    EXPECT_TRUE(shows("Nothing to undo"));

    const Show& show = w.session.settings.show;
    w.key(GLFW_KEY_V);
    ASSERT_EQ(show, Show::sources);
    w.key(GLFW_KEY_TAB);
    w.press("Cut the model");
    w.point_at(w.place("Cut at", 0.3));
    w.drag(0, 40, 0);
    const double cut_at = w.session.cut.share;
    EXPECT_NE(cut_at, 0.5);
    w.press("Cut the model");
    w.key(GLFW_KEY_TAB);
    w.key(GLFW_KEY_M);
    click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
    EXPECT_TRUE(w.there("distance 1"));
    w.key(GLFW_KEY_M);
    w.key(GLFW_KEY_E, control);
    w.press("Add a note");
    click(w, {1.6, 0, 3.7});
    w.press("Title of the note"), w.type("Tower"), w.key(GLFW_KEY_TAB), w.type("1702");
    const double mark = w.place("Note 1").y();
    w.point_at(w.place("Note 1")), w.drag(0, 0, -40);
    EXPECT_TRUE(w.place("Note 1").y() < mark - 20 && shows("Tower") && shows("1702"));

    undo();
    EXPECT_NEAR(w.place("Note 1").y(), mark, 1);
    EXPECT_TRUE(shows("Tower") && shows("1702")) << "the drag of a mark is one step";
    undo();
    EXPECT_TRUE(shows("Tower") && !shows("1702")) << "each field is one step";
    undo();
    EXPECT_TRUE(w.there("Note 1") && !shows("Tower"));
    undo();
    EXPECT_FALSE(w.there("Note 1"));
    EXPECT_FALSE(w.there("Snap to vertices"));
    undo();
    EXPECT_TRUE(w.there("Snap to vertices")) << "the panel shows the change";
    EXPECT_FALSE(w.there("distance 1"));
    EXPECT_FALSE(w.session.cut.on);
    undo();
    EXPECT_TRUE(w.session.cut.on && w.session.cut.share == cut_at);
    undo();
    EXPECT_TRUE(w.session.cut.on && w.session.cut.share == 0.5) << "a drag of a slider is one step";
    undo();
    EXPECT_FALSE(w.session.cut.on);
    EXPECT_EQ(show, Show::sources);
    undo();
    EXPECT_EQ(show, Show::colors);
    undo();
    EXPECT_TRUE(shows("Nothing to undo"));

    for (int i = 0; i < 9; ++i) redo();
    EXPECT_TRUE(show == Show::sources && w.session.cut.share == cut_at && !w.session.cut.on);
    EXPECT_TRUE(w.there("distance 1") && w.there("Note 1") && shows("Tower"));
    redo();
    EXPECT_TRUE(shows("Nothing to redo"));
    SurveyFile file = survey_file_of(dir / "one.vantage", false);
    written_until(w, file.path,
                  [&](const std::string&) { return read_survey(file, {}).measurements.size() == 1; });
    for (int i = 0; i < 5; ++i) undo();
    click(w, {1.6, 0, 3.7});
    undo();
    click(w, {1.6, 0, 3.7}), click(w, {1.6, 0, 5.3});
    EXPECT_TRUE(w.there("distance 1")) << "without the point that was undone";
    EXPECT_FALSE(w.there("distance 2"));
}

TEST_F(WindowUndo, TakesBackTheResetOfAGroupAndOfAll) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.resize(1200, 3000);
    w.key(GLFW_KEY_TAB);
    EXPECT_FALSE(w.there("Reset Picture") || w.there("Reset all")) << "nothing differs from the defaults";
    w.press("More Picture"), w.press("More Movement");
    Session& s = w.session;
    const bool& wireframe = s.settings.light.wireframe;
    w.press("Triangles");
    w.choose("Light", "normals");
    w.choose("Show", "which photo");
    EXPECT_TRUE(w.there("Reset Picture") && w.there("Reset Photos") && !w.there("Reset Movement"));
    w.press("Reset Picture");
    EXPECT_TRUE(!wireframe && s.settings.light.light == Light::photos);
    EXPECT_EQ(s.settings.show, Show::sources) << "this belongs to another group";
    EXPECT_FALSE(w.there("Reset Picture"));
    w.key(GLFW_KEY_Z, control);
    EXPECT_TRUE(wireframe && s.settings.light.light == Light::normals);

    w.press("Cut the model"), w.press("Inertia"), w.choose("Mode", "Average");
    w.choose("Stereo", "checkerboard");
    s.photos = {1};
    w.frames(3);
    const auto changed = [&] {
        return std::array{wireframe,
                          s.settings.show == Show::sources,
                          s.cut.on,
                          !s.movement.inertia,
                          s.settings.blend == Blend::average,
                          s.stereo.mode == StereoMode::checkerboard,
                          s.photos.size() == 1};
    };
    EXPECT_EQ(std::ranges::count(changed(), true), 7);
    w.press("Reset all");
    EXPECT_EQ(std::ranges::count(changed(), true), 0);
    EXPECT_FALSE(w.there("Reset all") || w.there("Reset Surveying"));
    w.key(GLFW_KEY_Z, control);
    EXPECT_EQ(std::ranges::count(changed(), true), 7) << "one step";
    w.press("Reset Surveying");
    EXPECT_FALSE(s.cut.on);
    EXPECT_FALSE(s.movement.inertia);
}
