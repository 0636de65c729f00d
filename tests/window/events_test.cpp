// The window's reactions to the mouse, keys and touch, including input that is faster than a frame.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include "player/view/photos_around.h"
#include "tests/window/window_test.h"

using namespace vantage;
using What = TouchEvent::What;

namespace {

class WindowEventsTest : public WindowTest {
  protected:
    static constexpr double degree = std::numbers::pi / 180;
    /// The camera's elevation above its target, in degrees.
    static double elevation(const HeadlessWindow& w) {
        const Eigen::Vector3d away = w.session.viewpoint.camera.eye - w.session.viewpoint.camera.target;
        return std::asin(away.normalized().dot(w.session.viewpoint.camera.up)) / degree;
    }
    static double distance(const HeadlessWindow& w) {
        return (w.session.viewpoint.camera.eye - w.session.viewpoint.camera.target).norm();
    }
    static Eigen::Vector2d pixel_of(const HeadlessWindow& w, const Eigen::Vector3d& point) {
        return project(w.view().intrinsics, w.view().cam_from_origin, point)->pixel;
    }
    /// The point on the model at `pixel`.
    static Eigen::Vector3d point_at(HeadlessWindow& w, const Eigen::Vector2d& pixel) {
        const auto hit = first_hit(w.scene(), ray_through(w.view(), pixel));
        EXPECT_TRUE(hit) << pixel.transpose();
        return hit ? hit->position : Eigen::Vector3d(0, 0, 0);
    }
    static void step_back(HeadlessWindow& w) {
        w.session.movement.near_photos = false;
        w.point_at({500, 400});
        w.wheel(-10);
    }
};

}  // namespace

TEST_F(WindowEventsTest, TapsQuickerThanAFrameAllActInOrder) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    EXPECT_FALSE(w.there("Section Picture")) << "the sidebar is open at the start";
    for (const int key : {GLFW_KEY_F3, GLFW_KEY_F5, GLFW_KEY_F6, GLFW_KEY_F6}) w.tap(key);
    w.frames(4);
    EXPECT_TRUE(w.session.window.panels.status && w.session.window.panels.frusta &&
                !w.session.window.panels.radar);
    EXPECT_TRUE(w.there("Section Picture")) << "F3 shows the sidebar with the picture's section";
    w.key(GLFW_KEY_C, control);
    EXPECT_FALSE(w.there("Swipe")) << "Ctrl+C compares";
    for (int i = 0; i < 3; ++i) w.tap(GLFW_KEY_C);
    w.frames(4);
    EXPECT_TRUE(w.there("Swipe"));
    for (const bool shown : {false, true}) {
        for (const int key : {GLFW_KEY_TAB, GLFW_KEY_C, GLFW_KEY_F5}) w.tap(key);
        w.frames(4);
        EXPECT_EQ(w.there("Section Picture"), shown);
        EXPECT_EQ(w.there("Swipe"), shown);
    }
}

TEST_F(WindowEventsTest, AClickQuickerThanAFrameIsWhereItWasMade) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    for (const bool shown : {true, false}) {
        w.point_at(w.place("Bar Expert"));
        w.button(0, true);
        w.button(0, false);
        w.point_at({450, 200});
        w.frames(4);
        EXPECT_EQ(w.there("Section Picture"), shown);
    }
}

TEST_F(WindowEventsTest, EscEndsWhatIsOpenAndNothingElse) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_C);
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.session.viewpoint.flight);
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.there("Swipe"));
    w.key(GLFW_KEY_O);
    EXPECT_TRUE(w.there("Cancel"));
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.there("Cancel"));
    w.key(GLFW_KEY_F6);
    EXPECT_TRUE(w.session.window.panels.radar) << "keys act again immediately";
    w.key(GLFW_KEY_F1);
    EXPECT_TRUE(w.session.window.panels.help);
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(w.session.window.panels.help);
    w.key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(holds<Quit>(w.session.window.commands));
    EXPECT_TRUE(w.there("Message")) << "Esc explains how to quit";
    w.tap(GLFW_KEY_O), w.tap(GLFW_KEY_ESCAPE);
    w.frames(4);
    EXPECT_FALSE(w.there("Cancel"));
    for (const int key : {GLFW_KEY_O, GLFW_KEY_C, GLFW_KEY_F5, GLFW_KEY_ESCAPE}) w.tap(key);
    w.frames(4);
    EXPECT_FALSE(w.there("Cancel"));
    EXPECT_FALSE(w.there("Swipe")) << "C is ignored behind the dialog";
    w.key(GLFW_KEY_Q, control);
    EXPECT_TRUE(take<Quit>(w.session.window.commands));
}

TEST_F(WindowEventsTest, EveryKeyOfTheHelpActs) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    Session& s = w.session;
    const Panels& p = s.window.panels;
    const auto toggles = [&](int key, const bool& value) {
        for (const bool wanted : {!value, bool(value)}) {
            w.key(key);
            EXPECT_EQ(value, wanted) << key;
        }
    };
    w.key(GLFW_KEY_TAB);  // F2 and others show the sidebar if it is closed
    toggles(GLFW_KEY_F1, p.help), toggles(GLFW_KEY_F2, p.blending), toggles(GLFW_KEY_F3, p.status);
    toggles(GLFW_KEY_F4, p.photos), toggles(GLFW_KEY_F5, p.frusta), toggles(GLFW_KEY_F6, p.radar);
    toggles(GLFW_KEY_F7, p.fields), toggles(GLFW_KEY_F8, p.points), toggles(GLFW_KEY_F9, p.image_sets);
    toggles(GLFW_KEY_F10, p.objects), toggles(GLFW_KEY_F11, s.window.full_screen),
        toggles(GLFW_KEY_F12, p.picture);
    toggles(GLFW_KEY_TAB, p.expert), toggles(GLFW_KEY_M, p.measure), toggles(GLFW_KEY_J, p.story);
    for (const Show shown : {Show::sources, Show::coverage, Show::colors}) {
        w.key(GLFW_KEY_V);
        EXPECT_EQ(s.settings.show, shown);
        EXPECT_EQ(w.there("Legend"), shown != Show::colors);
    }
    w.key(GLFW_KEY_P);
    EXPECT_TRUE(take<SaveScreenshot>(s.window.commands));
    w.key(GLFW_KEY_E, control);
    EXPECT_TRUE(p.story_editor);
    w.key(GLFW_KEY_E, control);
    EXPECT_FALSE(p.story_editor);
    w.key(GLFW_KEY_EQUAL, control);
    EXPECT_GT(s.window.text_scale, 1);
    w.key(GLFW_KEY_KP_SUBTRACT, control);
    EXPECT_FLOAT_EQ(s.window.text_scale, 1);
    EXPECT_TRUE(s.window.commands.empty());
    // Keys that move the camera.
    const auto moves = [&](int key, const Eigen::Vector3d& along, double seconds = 0.5) {
        const Navigation before = s.viewpoint.camera;
        w.hold(key, seconds);
        const Eigen::Vector3d moved = before.R * (s.viewpoint.camera.eye - before.eye);
        EXPECT_GT(moved.normalized().dot(along), 0.999) << key;
        return moved.norm();
    };
    moves(GLFW_KEY_D, {1, 0, 0}), moves(GLFW_KEY_A, {-1, 0, 0});
    moves(GLFW_KEY_W, {0, 0, 1}), moves(GLFW_KEY_S, {0, 0, -1});
    moves(GLFW_KEY_E, {0, -1, 0}), moves(GLFW_KEY_Q, {0, 1, 0});
    const double usual = moves(GLFW_KEY_D, {1, 0, 0});
    s.movement.flying_speed = 2;
    EXPECT_NEAR(moves(GLFW_KEY_A, {-1, 0, 0}) / usual, 2, 0.01);
    w.key(GLFW_KEY_H);
    w.wait(1);
    EXPECT_EQ(s.viewpoint.camera.eye, s.viewpoint.home.eye);
    EXPECT_EQ(s.viewpoint.camera.R, s.viewpoint.home.R);
}

TEST_F(WindowEventsTest, DigitsChooseTheBlendModes) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    std::array<Blend, 3> chosen;
    for (int i = 0; i < 3; ++i) {
        w.key(GLFW_KEY_1 + i);
        chosen[std::size_t(i)] = w.session.settings.blend;
    }
    std::ranges::sort(chosen);
    EXPECT_EQ(chosen, (std::array{Blend::average, Blend::lumigraph, Blend::best}));
}

TEST_F(WindowEventsTest, ADragTurnsHalfATurnPerWidthOfTheWindow) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    step_back(w);
    const double before = elevation(w), far = distance(w);
    w.point_at({450, 200});
    w.drag(0, 0, 60);
    EXPECT_NEAR(elevation(w) - before, 60 * 180 / 900.0, 0.01);
    EXPECT_NEAR(distance(w), far, 1e-6 * far);
    // A sideways drag orbits about the up axis.
    const Eigen::Vector3d from = w.session.viewpoint.camera.eye;
    w.point_at({450, 200});
    w.drag(0, 90, 0);
    EXPECT_GT((w.session.viewpoint.camera.eye - from).norm(), 1);
    EXPECT_NEAR(elevation(w) - before, 12, 0.01);
    const Eigen::Vector3d target = w.session.viewpoint.camera.target, nearer = target + 0.3 * (from - target);
    EXPECT_GT((pixel_of(w, nearer) - pixel_of(w, target)).x(), 5) << "the near side follows the pointer";
}

TEST_F(WindowEventsTest, WhatIsUnderThePointerStaysThere) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.session.movement.near_photos = false;
    const Eigen::Vector2d at(430, 300);
    Eigen::Vector3d point = point_at(w, at);
    for (const std::size_t button : {1, 2}) {
        const Eigen::Vector2d from = pixel_of(w, point);
        w.point_at(from);
        w.drag(button, 60, -30);
        EXPECT_LT((pixel_of(w, point) - from - Eigen::Vector2d(60, -30)).norm(), 0.5)
            << "dragged by " << button;
    }
    const Eigen::Vector2d here = pixel_of(w, point);
    const double far = (w.session.viewpoint.camera.eye - point).norm();
    w.point_at(here);
    for (int i = 0; i < 3; ++i) w.wheel(1);
    EXPECT_LT((pixel_of(w, point) - here).norm(), 0.5) << "after the wheel";
    EXPECT_NEAR((w.session.viewpoint.camera.eye - point).norm() / far, std::pow(0.9, 3), 1e-3);
    w.point_at(here);
    w.drag(0, 80, 20);
    EXPECT_LT((pixel_of(w, point) - here).norm(), 0.5) << "orbited";
    // With Ctrl, the camera rotates in place.
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    w.button(0, true), w.frames(2);
    w.hold_control(true), w.frames();
    w.point_at(here + Eigen::Vector2d(130, 20)), w.frames();
    w.hold_control(false);
    w.wait(0.3), w.button(0, false), w.frames(2);
    EXPECT_LT((w.session.viewpoint.camera.eye - eye).norm(), 1e-9);
}

TEST_F(WindowEventsTest, ADoubleClickFliesThere) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    const Eigen::Vector2d at(380, 330);
    const Eigen::Vector3d point = point_at(w, at);
    const double far = (w.session.viewpoint.camera.eye - point).norm();
    w.point_at(at);
    w.frames();
    w.double_click();
    w.wait(1);
    EXPECT_NEAR((w.session.viewpoint.camera.eye - point).norm() / far, 0.5, 1e-6);
    const Eigen::Vector2d middle(w.view().intrinsics.cx, w.view().intrinsics.cy);
    EXPECT_LT((pixel_of(w, point) - middle).norm(), 0.5);
}

TEST_F(WindowEventsTest, WhatIsLetGoInMotionMovesOn) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    step_back(w);
    const auto thrown = [&] {
        w.key(GLFW_KEY_H), w.wait(1);
        step_back(w);
        const double before = elevation(w);
        w.point_at({450, 200}), w.frames();
        w.button(0, true), w.frames(2);
        for (int i = 1; i <= 30; ++i) w.point_at({450, 200 + 8 * i}), w.frames();
        w.button(0, false);
        w.wait(3);
        return elevation(w) - before;
    };
    EXPECT_GT(thrown(), 49) << "degrees in total; 48 of these were dragged";
    w.session.movement.inertia = false;
    EXPECT_NEAR(thrown(), 48, 0.5);
}

TEST_F(WindowEventsTest, FingersOrbitPinchAndTap) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.session.movement.near_photos = false;
    w.touch(What::begin, 1, 450, 180), w.touch(What::move, 1, 450, 200), w.frames(2);  // no longer a tap
    const double before = elevation(w);
    for (int i = 1; i <= 6; ++i) w.touch(What::move, 1, 450, 200 + 10 * i), w.frames();
    w.wait(0.3), w.touch(What::end, 1, 450, 260), w.frames(3);
    EXPECT_NEAR(elevation(w) - before, 12, 0.01);
    // The point between two fingers stays in place, and the scene grows as the fingers spread.
    const Eigen::Vector2d middle(430, 300);
    const Eigen::Vector3d point = point_at(w, middle);
    const double far = depth_in(w.view(), point);
    w.touch(What::begin, 1, 380, 300), w.touch(What::begin, 2, 480, 300), w.frames(2);
    w.touch(What::move, 1, 355, 300), w.touch(What::move, 2, 505, 300), w.frames(2);
    w.touch(What::end, 1, 355, 300), w.touch(What::end, 2, 505, 300), w.frames(3);
    EXPECT_NEAR(far / depth_in(w.view(), point), 1.5, 0.02);
    EXPECT_LT((pixel_of(w, point) - middle).norm(), 1);
    const Eigen::Vector2d button = w.place("Bar Expert");
    w.touch(What::begin, 1, button.x(), button.y()), w.touch(What::end, 1, button.x(), button.y());
    w.frames(4);
    EXPECT_TRUE(w.session.window.panels.expert) << "a tap is a click";
}

TEST_F(WindowEventsTest, FlightsEndAtPhotosAndBackspaceLeadsBack) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.point_at({450, 200});
    const auto flown = [&](int key) {
        w.key(key), w.wait(1.5);
        return w.session.viewpoint.camera.eye;
    };
    flown(GLFW_KEY_N), flown(GLFW_KEY_B);
    const Eigen::Vector3d first = flown(GLFW_KEY_N);
    EXPECT_LT((first - w.scene().poses[w.session.viewpoint.standing_at].center()).norm(), 1e-9);
    const Eigen::Vector3d left = flown(GLFW_KEY_B);
    EXPECT_NE(left, first);
    EXPECT_EQ(flown(GLFW_KEY_N), first);
    EXPECT_EQ(flown(GLFW_KEY_BACKSPACE), left);
    EXPECT_EQ(flown(GLFW_KEY_BACKSPACE), first);
    // Input ends a flight.
    w.key(GLFW_KEY_N);
    EXPECT_TRUE(w.session.viewpoint.flight);
    w.wheel(1);
    EXPECT_FALSE(w.session.viewpoint.flight);
}

TEST_F(WindowEventsTest, NFliesAroundTheBuildingWhateverTheNames) {
    HeadlessWindow w(package_of(WindowScene::many));
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(w.package().scene().origin);
    const auto angle = [&](const Eigen::Vector3d& p) {
        return std::atan2(p.y() + origin.y(), p.x() + origin.x());
    };
    std::vector<double> angles;
    for (const Pose& pose : w.scene().poses) angles.push_back(angle(pose.center()));
    w.key(GLFW_KEY_N), w.wait(1);
    double from = angle(w.session.viewpoint.camera.eye);
    for (int i = 0; i < 5; ++i) {
        w.key(GLFW_KEY_N), w.wait(1);
        const double to = angle(w.session.viewpoint.camera.eye), low = std::min(from, to) + 1e-4,
                     high = std::max(from, to) - 1e-4;
        EXPECT_GT(high, low) << "N must move the camera";
        EXPECT_EQ(std::ranges::count_if(angles, [&](double a) { return a > low && a < high; }), 0)
            << "flies past other photos";
        from = to;
    }
    EXPECT_EQ(std::string(w.scene().photos[0].name), "0000.jpg");
}

TEST_F(WindowEventsTest, RecordsThirtyPositionsPerSecond) {
    HeadlessWindow w(copy_of(WindowScene::tiny));
    w.key(GLFW_KEY_R);
    w.wait(2);
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    w.point_at({450, 200});
    w.drag(0, 60, 0);
    w.key(GLFW_KEY_R);
    std::ifstream file(dir / "one-0001.path");
    int lines = 0;
    for (std::string line; std::getline(file, line);) lines += !line.starts_with('#');
    EXPECT_NEAR(lines, 30 * 2.6, 8);
    EXPECT_GT((w.session.path.positions.back().eye - eye).norm(), 1);
    EXPECT_LT((w.session.path.positions.front().eye - eye).norm(), 1e-9);
    w.key(GLFW_KEY_T);
    w.frames(3);
    EXPECT_LT((w.session.viewpoint.camera.eye - eye).norm(), 1e-9) << "a replay begins at the first position";
    w.wait(4);
    EXPECT_FALSE(w.session.viewpoint.flight);
    EXPECT_LT((w.session.viewpoint.camera.eye - w.session.path.positions.back().eye).norm(), 1e-9);
}

TEST_F(WindowEventsTest, TheStripScrollsAndFliesNowhere) {
    HeadlessWindow w(package_of(WindowScene::many));
    EXPECT_TRUE(w.there("Photo 60")) << "the strip contains all photos";
    const Eigen::Vector3d eye = w.session.viewpoint.camera.eye;
    const auto left = [&] { return w.place("Photo 3").x(); };
    double before = left();
    w.point_at(w.place("Photo 2")), w.frames();
    w.drag(0, -60, 0);
    EXPECT_NEAR(left() - before, -60, 4);
    before = left();
    w.point_at({300, w.place("Photo 2").y()}), w.frames();
    w.wheel(-1);
    EXPECT_LT(left(), before - 50) << "the wheel scrolls";
    EXPECT_EQ(w.session.viewpoint.camera.eye, eye);
    EXPECT_FALSE(w.session.viewpoint.flight);
    w.press("Photo 8");
    EXPECT_TRUE(w.session.viewpoint.flight);
}

TEST_F(WindowEventsTest, MessagesGoAfterSomeSeconds) {
    HeadlessWindow w(package_of(WindowScene::tiny));
    w.key(GLFW_KEY_BACKSPACE);
    EXPECT_TRUE(w.there("Message")) << "there is no view before the first";
    w.wait(5);
    EXPECT_TRUE(w.there("Message"));
    w.wait(2);
    EXPECT_FALSE(w.there("Message"));
}

TEST_F(WindowEventsTest, AKioskLetsThePublicLookOnly) {
    ShowOptions options;
    options.window.kiosk = true;
    options.window.home_after = 5;
    HeadlessWindow w(package_of(WindowScene::tiny), options);
    EXPECT_TRUE(w.there("Bar Home") && w.there("Bar Language"));
    EXPECT_FALSE(w.there("Bar Expert"));
    for (const int key : {GLFW_KEY_TAB, GLFW_KEY_O, GLFW_KEY_P, GLFW_KEY_R, GLFW_KEY_M, GLFW_KEY_F2,
                          GLFW_KEY_F11, GLFW_KEY_V, GLFW_KEY_J})
        w.key(key);
    w.key(GLFW_KEY_Q, control), w.key(GLFW_KEY_E, control), w.key(GLFW_KEY_C, control);
    const Session& s = w.session;
    EXPECT_TRUE(s.window.commands.empty());
    EXPECT_FALSE(s.path.recording || s.window.panels.expert || s.window.panels.measure ||
                 s.window.panels.story_editor);
    EXPECT_TRUE(s.window.full_screen && s.window.panels.story);
    EXPECT_EQ(s.settings.show, Show::colors);
    w.key(GLFW_KEY_F1);
    EXPECT_TRUE(s.window.panels.help);
    w.key(GLFW_KEY_N), w.wait(1);
    EXPECT_NE(s.viewpoint.camera.eye, s.viewpoint.home.eye);
    w.choose("Bar Language", "Deutsch");
    EXPECT_EQ(s.window.language, "de");
    w.press("Bar Language"), w.wait(7);
    EXPECT_EQ(s.viewpoint.camera.eye, s.viewpoint.home.eye) << "an idle kiosk returns to its first view";
    EXPECT_FALSE(s.window.panels.help || w.there("Deutsch"));
    EXPECT_EQ(s.window.language, "");
}
