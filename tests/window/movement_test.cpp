// Movements and auto-rotation end where there are no photos; tilted views are leveled. Without a movement, a
// sharp picture stays sharp. A finger drags handles in the picture instead of moving the view.
#include <fstream>
#include <set>

#include "player/view/photo_directions.h"
#include "player/window/input/orbit_limit.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class OrbitLimits : public WindowTest {};

class WindowTouch : public WindowTest {};

class WindowStillPicture : public WindowTest {
  protected:
    static void draw_until_final(HeadlessWindow& w) {
        for (int i = 0; i < 500 && !w.rests(); ++i) w.frames(), w.draw();
        ASSERT_TRUE(w.rests());
    }
    /// The number of photos' pictures in the interface.
    static std::size_t pictures() {
        std::set<ImTextureID> out;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int l = 0; l < data.CmdListsCount; ++l)
            for (const ImDrawCmd& command : data.CmdLists[l]->CmdBuffer)
                if (command.TextureId != ImGui::GetIO().Fonts->TexID) out.insert(command.TextureId);
        return out.size();
    }
};

}  // namespace

TEST_F(OrbitLimits, AutoRotationSwingsWithinThePhotosUntilTheFirstInput) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    const Viewpoint& v = w.session.viewpoint;
    const Eigen::Vector3d start = v.camera.eye, target = v.camera.target;
    const double distance = (start - target).norm();
    w.wait(1);
    EXPECT_EQ(v.camera.eye, start) << "it is off by default";
    w.key(GLFW_KEY_U);
    double moved = 0;
    int turns = 0;
    Eigen::Vector3d before = v.camera.eye, step = Eigen::Vector3d::Zero();
    for (int second = 0; second < 150; ++second) {
        w.wait(1);
        EXPECT_LE(angle_from_photos(w.package().photos(), v.camera.R.row(2).transpose()), free_angle + 0.01);
        EXPECT_NEAR((v.camera.eye - target).norm(), distance, 1e-3 * distance);
        EXPECT_EQ(v.camera.target, target);
        turns += step.dot(v.camera.eye - before) < 0;
        step = v.camera.eye - before, before = v.camera.eye;
        EXPECT_LT(step.norm(), 0.12 * distance) << "no jump";
        moved = std::max(moved, (v.camera.eye - start).norm());
    }
    EXPECT_GT(moved, 0.2 * distance);
    EXPECT_GE(turns, 2) << "it turns back at both ends";
    w.point_at({450, 200}), w.frames();
    EXPECT_TRUE(rotates(v)) << "a movement of the pointer does not stop it";
    w.click();
    EXPECT_FALSE(rotates(v));
    for (const int key : {GLFW_KEY_U, GLFW_KEY_V, GLFW_KEY_ESCAPE}) {
        w.key(GLFW_KEY_U);
        EXPECT_TRUE(rotates(v));
        w.key(key);
        EXPECT_FALSE(rotates(v));
    }
    w.key(GLFW_KEY_U), w.wheel(1);
    EXPECT_FALSE(rotates(v));
    w.session.movement.near_photos = false;
    w.key(GLFW_KEY_TAB), w.choose("View", "Auto-rotate"), w.wait(1);
    const auto beside = [&] {  // across the axis of the turn
        const Eigen::Vector3d from = v.camera.eye - v.camera.target, up = v.camera.up;
        return Eigen::Vector3d(from - from.dot(up) * up);
    };
    const Eigen::Vector3d before_turn = beside();
    w.wait(44);
    EXPECT_LT((beside() + before_turn).norm(), 0.2 * before_turn.norm()) << "half a turn in 45 seconds";
}

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

TEST_F(OrbitLimits, TheModelStaysInThePicture) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    const auto rays_on_mesh = [&] {
        int hits = 0;
        for (int x = 20; x < w.view().intrinsics.width; x += 20)
            for (int y = 20; y < w.view().intrinsics.height; y += 20)
                hits += first_hit(w.scene(), ray_through(w.view(), {x, y})).has_value();
        return hits;
    };
    const auto pan_away = [&] {
        for (int i = 0; i < 20; ++i) w.point_at({200, 300}), w.frames(), w.drag(1, 300, 0), w.wait(0.5);
    };
    pan_away();
    EXPECT_GT(rays_on_mesh(), 5);
    w.key(GLFW_KEY_H), w.wait(2);
    w.session.movement.near_photos = false;
    pan_away();
    EXPECT_EQ(rays_on_mesh(), 0);
}

TEST_F(OrbitLimits, AStorySetsThem) {
    const std::filesystem::path package = copy_of(WindowScene::tiny);
    const auto zoom_out = [&] {
        HeadlessWindow w(package);
        const Eigen::Vector2d middle(w.view().intrinsics.cx, w.view().intrinsics.cy);
        const Eigen::Vector3d point = first_hit(w.scene(), ray_through(w.view(), middle))->position;
        w.point_at(middle), w.frames();
        for (int i = 0; i < 60; ++i) w.wheel(-1);
        EXPECT_EQ(w.session.movement, w.session.defaults.movement);
        return std::pair((w.session.viewpoint.camera.eye - point).norm(), w.session.movement.near_photos);
    };
    const auto [automatic, near] = zoom_out();
    EXPECT_TRUE(near);
    const auto told = [&](const std::string& limits) {
        std::ofstream(dir / "one.story.json")
            << R"({"format": "vantage-story-1", "limits": )" << limits << "}";
        return zoom_out();
    };
    EXPECT_NEAR(told(R"({"farthest": 20})").first, 20, 0.1);
    const auto [far, stays] = told(R"({"near_photos": false})");
    EXPECT_GT(far, 2 * automatic);
    EXPECT_FALSE(stays);
}

TEST_F(OrbitLimits, ATiltedViewIsLeveled) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    Navigation& camera = w.session.viewpoint.camera;
    const auto level_in_menu = [&] {
        w.press("View");
        const bool there = w.there("Level");
        w.press("View");
        return there;
    };
    w.key(GLFW_KEY_TAB);
    EXPECT_FALSE(level_in_menu()) << "the view has no roll";
    const Navigation upright = camera;
    for (const double degrees : {25.0, -140.0}) {
        camera.R = rolled(upright.R, degrees);
        w.frames();
        if (degrees > 0)
            w.choose("View", "Level");
        else
            w.key(GLFW_KEY_L);
        EXPECT_GT(std::abs(roll_of(camera.R, camera.up)), 0.1) << "it is a flight";
        w.wait(1);
        EXPECT_LT((camera.R - upright.R).norm(), 1e-9);
        EXPECT_EQ(camera.eye, upright.eye);
        EXPECT_FALSE(level_in_menu());
        w.key(GLFW_KEY_L);
        EXPECT_FALSE(w.session.viewpoint.flight) << "the view is level";
    }
}

TEST_F(WindowStillPicture, LiesUnderPanels) {
    HeadlessWindow w(package_of(WindowScene::many));
    draw_until_final(w);
    const View drawn = w.view();
    for (const int key : {GLFW_KEY_TAB, GLFW_KEY_F1, GLFW_KEY_F1, GLFW_KEY_F4, GLFW_KEY_F4, GLFW_KEY_F6,
                          GLFW_KEY_F8, GLFW_KEY_M, GLFW_KEY_TAB}) {
        w.key(key);
        w.draw();
        EXPECT_TRUE(w.rests() && same_view(w.view(), drawn)) << "after the key " << key;
    }
    w.point_at(w.place("Bar Home"));
    w.frames(3), w.draw();
    EXPECT_TRUE(w.rests()) << "after pointing at a button";

    const std::size_t photos = pictures();
    EXPECT_GT(photos, 3u);
    w.point_at(w.place("Photo 2"));
    w.wheel(-9);
    w.frames();
    EXPECT_LT(pictures(), photos) << "the strip shows photos that are not loaded";
    for (int i = 0; i < 500 && pictures() < photos; ++i) {
        w.draw();
        EXPECT_TRUE(w.rests()) << "while photos for the strip are loaded";
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        w.frames();
    }
    EXPECT_EQ(pictures(), photos);
}

TEST_F(WindowStillPicture, IsRefinedWhileAPanelIsMoved) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_F6);
    draw_until_final(w);
    w.point_at({300, 300});
    w.wheel(1);
    const Pace full{};
    for (int i = 0; i < 100 && (w.rests() || w.session.drawn.pace != full); ++i) w.draw(), w.frames();
    const Area free = w.session.window.free;
    const double em = double(ImGui::GetFontSize());
    Eigen::Vector2d title(free.left + free.width - 14 * em, free.top + 1.5 * em);
    w.point_at(title), w.frames();
    w.button(0, true), w.frames();
    for (int i = 0; i < 500 && !w.rests(); ++i) {
        w.point_at(title += Eigen::Vector2d(-1, 1)), w.frames();
        w.draw();
        ASSERT_EQ(w.session.drawn.pace, full) << "the picture becomes coarse";
    }
    EXPECT_TRUE(ImGui::IsAnyItemActive()) << "no panel was moved";
}

TEST_F(WindowStillPicture, MovesBesideThePanelsWithTheNextFlight) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    const double before = w.view().intrinsics.cx;
    w.key(GLFW_KEY_TAB);
    w.wait(1);
    EXPECT_EQ(w.view().intrinsics.cx, before);
    const Area free = w.session.window.free;
    const double beside = free.left + free.width / 2;
    EXPECT_GT(beside, before + 50);
    w.tap(GLFW_KEY_H);
    w.frames(3);
    EXPECT_NEAR(w.view().intrinsics.cx, before, 0.4 * (beside - before)) << "the picture jumps";
    w.wait(1);
    EXPECT_EQ(w.view().intrinsics.cx, beside);
}

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
