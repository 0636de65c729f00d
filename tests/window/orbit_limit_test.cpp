// Drags and zooming out end where there are no photos.
#include "player/window/input/orbit_limit.h"

#include "player/view/photo_directions.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class OrbitLimits : public WindowTest {};

}  // namespace

TEST_F(OrbitLimits, OrbitsReturnToTheDirectionsOfThePhotos) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    const Steering& steering = w.session.steering;
    w.session.movement.inertia = false;
    const auto angle = [&] {
        return angle_from_photos(w.package().photos(), w.session.viewpoint.camera.R.row(2).transpose());
    };
    const auto drag_down = [&] {
        w.point_at({450, 200}), w.frames();
        w.button(0, true), w.frames(2);
        for (int i = 1; i <= 40; ++i) w.point_at({450, 200 + 8 * i}), w.frames();
    };
    drag_down();
    EXPECT_TRUE(angle() > free_angle && angle() < 2 * free_angle) << angle();
    EXPECT_TRUE(steering.inside) << "the cameras are shown";
    w.button(0, false), w.wait(2);
    EXPECT_LE(angle(), free_angle);
    EXPECT_FALSE(steering.inside);
    const auto zoom_out = [&] {
        for (int i = 0; i < 60; ++i) w.wheel(-1);
        return (w.session.viewpoint.camera.eye - w.session.viewpoint.camera.target).norm();
    };
    const double far = zoom_out();
    w.session.movement.near_photos = false;
    EXPECT_GT(zoom_out(), 2 * far);
    w.key(GLFW_KEY_H), w.wait(2);
    drag_down();
    EXPECT_GT(angle(), 2 * free_angle);
    w.button(0, false), w.wait(2);
    EXPECT_GT(angle(), 2 * free_angle);
}
