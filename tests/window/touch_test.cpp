// Handles in the picture are dragged by a finger.
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class WindowTouch : public WindowTest {};

}  // namespace

TEST_F(WindowTouch, AFingerDragsTheLampAndTheSwipe) {
    using What = TouchEvent::What;
    HeadlessWindow w(package_of(WindowScene::tiny));
    const auto drag = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& by) {
        w.touch(What::begin, 1, from.x(), from.y()), w.frames();
        for (int i = 1; i <= 10; ++i) {
            const Eigen::Vector2d at = from + i * by / 10;
            w.touch(What::move, 1, at.x(), at.y()), w.frames();
        }
        w.touch(What::end, 1, from.x() + by.x(), from.y() + by.y()), w.frames(3);
    };
    w.press("Bar Light");
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    const Area& free = w.session.window.free;
    const Eigen::Vector2d middle(free.left + free.width / 2, free.top + free.height / 2),
        lamp = w.place("Lamp");
    drag(lamp, {2 * (middle - lamp).x(), 0});
    EXPECT_NEAR(w.session.settings.light.azimuth, 45, 1);
    EXPECT_NEAR(w.session.settings.light.elevation, 15, 1);
    EXPECT_EQ(w.session.viewpoint.camera.eye, eye) << "the finger does not orbit";
    w.press("Bar Compare"), w.wait(1);
    drag(w.place("Swipe", 0.5), {180, 0});
    EXPECT_NEAR(w.session.settings.swipe, 0.7, 0.01);
}
