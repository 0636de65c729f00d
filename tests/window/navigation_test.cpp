// The window is used with keys alone, and the strip marks photos.
#include <algorithm>
#include <string>

#include "player/plan/plan.h"
#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowNavigation : public WindowTest {
  protected:
    static bool marked(const HeadlessWindow& w) { return w.session.window.navigates; }
    /// The tooltip of the photo at which the viewer stands, once photos have been chosen for the view.
    static std::string told_where_one_stands(HeadlessWindow& w) {
        for (int i = 0; i < 3; ++i) w.draw(), w.wait(0.5);
        for (int number = 1; number <= 5; ++number) {
            w.point_at(w.place("Photo " + std::to_string(number))), w.frames(3);
            if (std::string text = shown_text(); text.find("you are here") != text.npos) return text;
        }
        ADD_FAILURE() << "no photo is marked";
        return {};
    }
    /// The middle of a narrow white line as high as the free area; -1 if there is none.
    static double line_over_picture(const HeadlessWindow& w) {
        const Area& free = w.session.window.free;
        const ImVector<ImDrawVert>& v = ImGui::GetDrawData()->CmdLists[0]->VtxBuffer;
        for (int i = 0; i + 2 < v.Size; ++i) {
            const ImVec2 low = v[i].pos, high = v[i + 2].pos;
            if (v[i].col == IM_COL32_WHITE && high.x - low.x > 1 && high.x - low.x < 6 &&
                double(high.y - low.y) >= 0.99 * free.height)
                return double(low.x + high.x) / 2;
        }
        return -1;
    }
    /// The percentage in the tooltip.
    static int match_told() {
        const std::string text = shown_text(), before = "matches this view to ";
        const std::size_t at = text.find(before);
        return at == text.npos ? -1 : std::stoi(text.substr(at + before.size()));
    }
};

}  // namespace

TEST_F(WindowNavigation, ArrowKeysReachTheToolsAndSpaceOrEnterUsesThem) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.press("Bar Home");
    w.wait(1);
    w.key(GLFW_KEY_RIGHT);
    EXPECT_TRUE(marked(w));
    w.key(GLFW_KEY_SPACE);
    EXPECT_FALSE(w.session.window.panels.photos) << "this is the tool beside Home";
    w.key(GLFW_KEY_ENTER);
    EXPECT_TRUE(w.session.window.panels.photos);
    w.key(GLFW_KEY_RIGHT), w.key(GLFW_KEY_ENTER);
    w.wait(1);
    EXPECT_TRUE(w.there("Swipe"));
    w.key(GLFW_KEY_ENTER);
    EXPECT_FALSE(w.there("Swipe")) << "the comparison has removed the mark";
    w.point_at({450, 300}), w.frames();
    w.click();
    EXPECT_FALSE(marked(w));
}

TEST_F(WindowNavigation, KeysOfTheProgramWorkWhileAControlIsMarked) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.resize(1200, 3000);
    w.key(GLFW_KEY_TAB);
    w.press("More Status");
    w.key(GLFW_KEY_DOWN), w.key(GLFW_KEY_UP);
    ASSERT_TRUE(marked(w));
    for (const bool more : {true, false}) {
        w.key(GLFW_KEY_ENTER);
        EXPECT_EQ(w.session.window.panels.movement, more) << "More, above the one that was clicked";
    }
    w.key(GLFW_KEY_M);
    EXPECT_TRUE(w.session.window.panels.measure);
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    w.hold(GLFW_KEY_W, 0.3);
    EXPECT_NE(w.session.viewpoint.camera.eye, eye);
    w.key(GLFW_KEY_TAB);
    EXPECT_FALSE(w.session.window.panels.expert);
}

TEST_F(WindowNavigation, EscLeavesTheMarkedControlFirst) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.resize(1200, 3000);
    w.key(GLFW_KEY_TAB);
    w.key(GLFW_KEY_M);
    w.press("More Status");
    w.key(GLFW_KEY_DOWN), w.key(GLFW_KEY_UP);
    ASSERT_TRUE(marked(w));
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_TRUE(w.session.window.panels.measure);
    EXPECT_FALSE(marked(w));
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.session.window.panels.measure);
}

TEST_F(WindowNavigation, APhotoOfTheStripIsChosenByKeys) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.point_at(w.place("Photo 1")), w.frames();
    w.drag(0, 0, 40);  // gives the strip the keyboard, and is no click
    ASSERT_FALSE(w.session.viewpoint.flight);
    w.point_at({450, 300}), w.frames();
    w.key(GLFW_KEY_RIGHT), w.key(GLFW_KEY_RIGHT);
    ASSERT_TRUE(marked(w));
    w.key(GLFW_KEY_ENTER);
    w.wait(2);
    const auto stands_at = [&](const Pose& pose) { return pose.center() == w.session.viewpoint.camera.eye; };
    EXPECT_TRUE(std::ranges::any_of(w.scene().poses, stands_at));
    EXPECT_NE(shown_text().find("you are here"), std::string::npos) << shown_text();
}

TEST_F(WindowNavigation, TheStripSaysWhatAPhotoIs) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.draw(), w.frames(2);
    w.point_at(w.place("Photo 1")), w.frames(3);
    EXPECT_NE(shown_text().find("blended"), std::string::npos) << shown_text();
    w.session.photos.clear();
    w.frames(3);
    EXPECT_NE(shown_text().find("excluded"), std::string::npos) << shown_text();
}

TEST_F(WindowNavigation, TheStripSaysHowWellAPhotoMatchesThePresentView) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.resize(300, 700);
    w.point_at(w.place("Photo 1")), w.frames();
    w.wheel(-20);
    w.point_at(w.place("Photo 5")), w.frames(3);
    const int before = match_told();
    EXPECT_LT(before, 30) << shown_text();
    w.click();
    w.wait(2);
    EXPECT_NE(shown_text().find("you are here"), std::string::npos) << shown_text();
    EXPECT_EQ(match_told(), -1) << "of its own view, a photo may show less than the window";
    std::vector<double> matches = agreements(w.scene(), w.view());
    std::ranges::sort(matches, std::ranges::greater());
    w.point_at({150, 300}), w.frames(3);
    w.point_at(w.place("Photo 1")), w.frames(3);
    EXPECT_NE(shown_text().find("you are here"), std::string::npos)
        << "sorted, and scrolled to the beginning";
    w.point_at(w.place("Photo 2")), w.frames(3);
    EXPECT_NEAR(match_told(), 100 * matches[1], 0.51) << shown_text();
    EXPECT_GT(match_told(), before);
}

TEST_F(WindowNavigation, AViewReadFromTextIsThatOfThePhoto) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_N), w.wait(1);
    w.key(GLFW_KEY_C, control);
    w.key(GLFW_KEY_N), w.wait(1);
    w.key(GLFW_KEY_V, control);
    w.wait(1);
    told_where_one_stands(w);
    w.session.viewpoint.orthographic = true;
    w.frames(3);
    EXPECT_NE(shown_text().find("matches this view"), std::string::npos) << shown_text();
    EXPECT_EQ(shown_text().find("you are here"), std::string::npos) << "an orthographic view is from nowhere";
}

TEST_F(WindowNavigation, AComparedPhotoIsNotBlendedUntilTheComparisonEnds) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_C);
    w.wait(1);
    EXPECT_NE(shown_text().find("model without this photo"), std::string::npos) << shown_text();
    const std::size_t photo = w.session.settings.compare_photo;
    EXPECT_EQ(shown_text().find(w.scene().photos[photo].name), std::string::npos) << shown_text();
    w.session.settings.swipe = 0.3;
    w.frames();
    EXPECT_NEAR(line_over_picture(w), 0.3 * 900, 2) << "its edges are sharp while the picture is coarse";
    w.key(GLFW_KEY_TAB);
    EXPECT_NE(shown_text().find(w.scene().photos[photo].name), std::string::npos)
        << "as in the list of photos";
    w.key(GLFW_KEY_TAB);
    EXPECT_EQ(told_where_one_stands(w).find("blended"), std::string::npos) << shown_text();
    w.key(GLFW_KEY_C);
    EXPECT_NE(told_where_one_stands(w).find("blended"), std::string::npos) << shown_text();
}
