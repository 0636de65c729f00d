#include "player/headset/locomotion/pointing.h"

#include <gtest/gtest.h>

#include "player/headset/menu_place.h"

namespace vantage {
namespace {

using Eigen::Vector3d;

/// A menu in front of the user, and two hands that point into the distance.
class PointingAtTheMenu : public testing::Test {
  protected:
    PointingAtTheMenu() {
        for (Hand& hand : hands) point(hand, {0, 1.6, 5});
    }
    static void point(Hand& hand, const Vector3d& to) {
        const Vector3d from(0.2, 1.2, -0.1);
        hand.aim = RoomPose{Eigen::Quaterniond::FromTwoVectors(-Vector3d::UnitZ(), to - from), from};
    }
    /// Points at a pixel of the menu.
    void at_pixel(std::size_t hand, double x, double y) { point(hands[hand], point_on(*menu, {x, y})); }
    void step() {
        const PointingTargets targets{menu, {}, origin, story, scene, session};
        for (std::size_t i = 0; i < 2; ++i) pointed[i] = pointed_by(hands[i], {}, targets);
        pointer = next_menu_pointer(pointer, hands, pointed, selected, {}, menu);
        for (std::size_t i = 0; i < 2; ++i) selected[i] = hands[i].select;
    }

    std::optional<Panel> menu = menu_panel(menu_in_front_of({{1, 0, 0, 0}, {0, 1.6, 0}}), {},
                                           SceneInterface::width, SceneInterface::height);
    Vector3d origin = Vector3d::Zero();
    Story story;
    PlanScene scene;
    WindowState window;
    Session session{window};
    Hands hands;
    std::array<Pointed, 2> pointed;
    std::array<bool, 2> selected{};
    MenuPointer pointer;
};

TEST_F(PointingAtTheMenu, GivesThePixelAndTheLengthOfTheRay) {
    at_pixel(left_hand, 100, 200);
    step();
    EXPECT_EQ(pointer.hand, left_hand);
    ASSERT_TRUE(pointer.pointer.at);
    EXPECT_LT((*pointer.pointer.at - Eigen::Vector2d(100, 200)).norm(), 1e-6);
    EXPECT_FALSE(pointer.pointer.pressed);
    EXPECT_NEAR(pointed[left_hand].length, (point_on(*menu, {100, 200}) - hands[left_hand].aim->at).norm(),
                1e-9);
    at_pixel(right_hand, 300, 400);
    step();
    EXPECT_EQ(pointer.hand, right_hand) << "the right hand comes first";
}

TEST_F(PointingAtTheMenu, SliderIsHeldBesideTheMenuUntilItIsLetGo) {
    at_pixel(right_hand, 800, 300);
    step();
    hands[right_hand].select = true;
    step();
    EXPECT_TRUE(pointer.pointer.pressed);
    at_pixel(right_hand, 2000, 300);
    at_pixel(left_hand, 100, 100);  // the other hand does not take over
    step();
    EXPECT_TRUE(pointer.pointer.pressed);
    EXPECT_EQ(pointer.hand, right_hand);
    EXPECT_NEAR(pointer.pointer.at->x(), 2000, 1e-6);
    hands[right_hand].select = false;
    step();
    EXPECT_FALSE(pointer.pointer.pressed);
    EXPECT_EQ(pointer.hand, left_hand);
}

TEST_F(PointingAtTheMenu, PressThatBeganElsewhereClicksNothing) {
    hands[right_hand].select = true;
    step();
    at_pixel(right_hand, 400, 300);
    step();
    EXPECT_TRUE(pointer.pointer.at);
    EXPECT_FALSE(pointer.pointer.pressed);
}

TEST_F(PointingAtTheMenu, HandThatIsLostOrAMenuThatClosesLetsGo) {
    at_pixel(right_hand, 400, 300);
    step();
    hands[right_hand].select = true;
    step();
    ASSERT_TRUE(pointer.pointer.pressed);
    Hands lost = hands;
    std::swap(lost, hands);
    hands[right_hand] = {};
    step();
    EXPECT_FALSE(pointer.pointer.pressed);
    hands = lost;
    menu.reset();
    step();
    EXPECT_FALSE(pointer.hand || pointer.pointer.at || pointer.pointer.pressed);
}

TEST_F(PointingAtTheMenu, NearestNoteIsMetUnlessTheMenuHidesIt) {
    const Vector3d from = hands[right_hand].aim->at, along = hands[right_hand].aim->ahead();
    for (const double away : {4.0, 2.0}) {
        StoryNote note;
        note.anchor = from + along * away;
        story.notes.push_back(note);
    }
    step();
    EXPECT_EQ(pointed[right_hand].note, 1u);
    EXPECT_NEAR(pointed[right_hand].length, 2, 1e-9);
    session.window.panels.measure = true;
    step();
    EXPECT_FALSE(pointed[right_hand].note) << "while measuring, hands point at surfaces, not at notes";
    session.window.panels.measure = false;
    at_pixel(right_hand, 400, 300);
    story.notes[0].anchor = from + hands[right_hand].aim->ahead() * 3;
    step();
    EXPECT_FALSE(pointed[right_hand].note);
    EXPECT_TRUE(pointed[right_hand].menu);
}

}  // namespace
}  // namespace vantage
