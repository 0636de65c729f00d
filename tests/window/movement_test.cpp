// Movements end where there are no photos. Without a movement, a sharp picture stays sharp.
#include <set>

#include "player/view/photo_directions.h"
#include "player/window/input/orbit_limit.h"
#include "tests/window/window_test.h"

using namespace vantage;

namespace {

class OrbitLimits : public WindowTest {};

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
