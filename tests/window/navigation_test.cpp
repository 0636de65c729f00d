// The window used by keys alone.
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
    EXPECT_FALSE(w.session.window.panels.photos) << "the tool beside Home";
    w.key(GLFW_KEY_ENTER);
    EXPECT_TRUE(w.session.window.panels.photos);
    w.key(GLFW_KEY_RIGHT), w.key(GLFW_KEY_ENTER);
    w.wait(1);
    EXPECT_TRUE(w.there("Swipe"));
    w.key(GLFW_KEY_ENTER);
    EXPECT_FALSE(w.there("Swipe")) << "the comparison has taken the mark away";
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
