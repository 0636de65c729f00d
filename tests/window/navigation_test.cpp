// The window is used with keys alone, and the strip marks photos.
#include <algorithm>

#include "tests/window/shown_text.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowNavigation : public WindowTest {
  protected:
    static bool marked(const HeadlessWindow& w) { return w.session.window.navigates; }
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
    w.press("Section Status");
    w.key(GLFW_KEY_DOWN), w.key(GLFW_KEY_UP);
    ASSERT_TRUE(marked(w));
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
    w.press("Section Status");
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
