#include "player/headset/locomotion/locomotion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vantage {
namespace {

using Eigen::Vector3d;

constexpr double frame = 1.0 / 90;

/// A pose that points from a position in the room, `up` radians above the horizontal and `left` radians to
/// the left of straight ahead.
RoomPose aiming(const Vector3d& at, double up, double left = 0) {
    return {Eigen::Quaterniond(Eigen::AngleAxisd(left, Vector3d::UnitY()) *
                               Eigen::AngleAxisd(up, Vector3d::UnitX())),
            at};
}

/// A room away from the scene's origin, with ten scene units per meter and z up.
class LocomotionTest : public testing::Test {
  protected:
    LocomotionTest() {
        head.at = {0.2, 1.6, 0.1};
        w.stance = standing(head, {5, 6, 16}, {5, 100, 16}, Vector3d::UnitZ(), 10);
        w.usual_scale = 10;
        for (Hand& hand : hands) {
            hand.has_stick = true;
            hand.aim = hand.grip = aiming({0.2, 1.2, -0.3}, 0);
        }
        step();  // the sticks are centered
    }
    void step(int frames = 1) {
        for (int i = 0; i < frames; ++i) continue_locomotion(w, hands, free, head, frame, surface);
    }
    void stick(std::size_t hand, double right, double ahead) { hands[hand].stick = {right, ahead}; }
    Vector3d eye() const { return in_scene(w.stance, head.at); }
    Vector3d ahead() const { return w.stance.R * head.ahead(); }

    Locomotion w;
    Hands hands;
    FreeHands free{};
    RoomPose head;
    SurfaceBetween surface = [](const Vector3d&, const Vector3d&) { return std::optional<SurfacePoint>(); };
};

/// A level floor at height `z` in the scene.
SurfaceBetween floor_at(double z) {
    return [z](const Vector3d& from, const Vector3d& to) -> std::optional<SurfacePoint> {
        if (!(from.z() > z && to.z() <= z)) return {};
        return SurfacePoint{from + (to - from) * ((from.z() - z) / (from.z() - to.z())), Vector3d::UnitZ()};
    };
}

TEST_F(LocomotionTest, StickToTheSideTurnsOnceByThirtyDegrees) {
    const Vector3d before = ahead(), at = eye();
    stick(right_hand, 1, 0);
    step(50);
    EXPECT_NEAR(std::acos(before.dot(ahead())), std::numbers::pi / 6, 1e-9);
    EXPECT_LT(before.cross(ahead()).z(), 0) << "to the right";
    EXPECT_LT((eye() - at).norm(), 1e-9);
    stick(right_hand, 0, 0);
    step();
    stick(right_hand, -1, 0);
    step(50);
    EXPECT_LT((ahead() - before).norm(), 1e-9) << "and back";
}

TEST_F(LocomotionTest, TeleportsToWhereAThrownStoneWouldFall) {
    surface = floor_at(0);
    const double up = 0.3, height = 1.2, speed = 7.5, g = 9.81;
    hands[right_hand].aim = aiming({0.2, height, -0.3}, up);
    stick(right_hand, 0, 1);
    step(5);
    ASSERT_TRUE(w.arc && w.arc->landing);
    EXPECT_EQ(eye(), in_scene(w.stance, head.at)) << "not yet";
    const double rise = speed * std::sin(up);
    const double seconds = (rise + std::sqrt(rise * rise + 2 * g * height)) / g;
    const double away = 0.3 + speed * std::cos(up) * seconds;  // meters ahead of the room's center
    stick(right_hand, 0, 0);
    const Vector3d middle = w.stance.at;
    step();
    EXPECT_FALSE(w.arc);
    EXPECT_NEAR(eye().z(), 16, 1e-6);
    EXPECT_NEAR(eye().y() - middle.y(), 10 * away, 0.3) << "the arc is drawn with straight segments";
    EXPECT_NEAR(eye().x(), middle.x() + 2, 0.01);
}

TEST_F(LocomotionTest, StandsBeforeAWallAndNotInIt) {
    const double wall = 20;
    surface = [&](const Vector3d& from, const Vector3d& to) -> std::optional<SurfacePoint> {
        if (from.y() < wall && to.y() >= wall)
            return SurfacePoint{from + (to - from) * ((wall - from.y()) / (to.y() - from.y())),
                                -Vector3d::UnitY()};
        return floor_at(0)(from, to);
    };
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc && w.arc->landing);
    EXPECT_NEAR(w.arc->landing->z(), 0, 1e-9);
    EXPECT_NEAR(w.arc->landing->y(), wall - 5, 1e-9) << "the user lands half a meter in front of the wall";
}

TEST_F(LocomotionTest, ASteepRoofIsNoPlaceToStand) {
    surface = [](const Vector3d& from, const Vector3d& to) -> std::optional<SurfacePoint> {
        auto hit = floor_at(5)(from, to);
        if (hit) hit->normal = Vector3d(0, -std::sin(1.2), std::cos(1.2));
        return hit;
    };
    const Stance before = w.stance;
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc);
    EXPECT_FALSE(w.arc->landing);
    stick(right_hand, 0, 0);
    step();
    EXPECT_EQ(w.stance.at, before.at);
}

TEST_F(LocomotionTest, WithoutAFloorItLandsAtTheFeetsLevel) {
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc && w.arc->landing);
    EXPECT_NEAR(w.arc->landing->z(), 0, 1e-9);
    for (const Vector3d& p : w.arc->points) EXPECT_GE(p.z(), -1e-9);
}

TEST_F(LocomotionTest, StepDownOfTwoMetersIsFound) {
    surface = floor_at(-20);
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc && w.arc->landing);
    EXPECT_NEAR(w.arc->landing->z(), -20, 1e-9);
}

TEST_F(LocomotionTest, StickOfTheOtherHandFliesWhereItPointsAtTheSameSpeedAtEveryFrameRate) {
    hands[left_hand].aim = aiming({0, 1, 0}, 0.5, 0.4);
    stick(left_hand, 0, 1);
    const Vector3d from = eye();
    step(90);
    const Vector3d flown = eye() - from, along = w.stance.R * hands[left_hand].aim->ahead();
    EXPECT_LT((flown - along * 20).norm(), 1e-6) << "flying covers two meters per second";
    EXPECT_NEAR(w.vignette, 1, 1e-9);
    stick(left_hand, 0, 0);
    step(30);
    EXPECT_EQ(w.vignette, 0);
    continue_locomotion(w, hands, free, head, 1000, surface);
    EXPECT_LT((eye() - from - flown).norm(), 1e-9);
}

TEST_F(LocomotionTest, RestingThumbDoesNotDrift) {
    const Vector3d from = eye();
    stick(left_hand, 0.1, -0.1);
    stick(right_hand, 0.1, -0.1);
    step(900);
    EXPECT_EQ(eye(), from);
}

TEST_F(LocomotionTest, TwoHandsScaleTheScene) {
    hands[left_hand].grip->at = {-0.2, 1, -0.5};
    hands[right_hand].grip->at = {0.2, 1, -0.5};
    hands[left_hand].squeeze = hands[right_hand].squeeze = true;
    step();
    hands[left_hand].grip->at = {-0.4, 1, -0.5};
    hands[right_hand].grip->at = {0.4, 1, -0.5};
    step();
    EXPECT_NEAR(w.stance.scale, 5, 1e-9) << "twice as large";
    hands[left_hand].squeeze = hands[right_hand].squeeze = false;
    hands[left_hand].grip->at = {-1, 1, -0.5};
    step();
    EXPECT_NEAR(w.stance.scale, 5, 1e-9);
}

TEST_F(LocomotionTest, SecondHandThatJoinsDoesNotMoveAnything) {
    hands[left_hand].squeeze = true;
    step();
    hands[left_hand].grip->at += Vector3d(0.1, 0.2, 0.3);
    step();
    const Stance one = w.stance;
    hands[right_hand].squeeze = true;
    step();
    EXPECT_LT((w.stance.at - one.at).norm(), 1e-12);
    EXPECT_NEAR(w.stance.scale, one.scale, 1e-12);
}

TEST_F(LocomotionTest, ControllersWithoutSticksAimBySelecting) {
    surface = floor_at(0);
    for (Hand& hand : hands) hand.has_stick = false;
    hands[left_hand].select = true;
    step(3);
    ASSERT_TRUE(w.arc && w.arc->landing);
    EXPECT_EQ(w.aiming, left_hand);
    const Vector3d there = *w.arc->landing;
    hands[left_hand].select = false;
    step();
    EXPECT_LT((in_scene(w.stance, {head.at.x(), 0, head.at.z()}) - there).norm(), 1e-9);
}

TEST_F(LocomotionTest, PressThatBeganOnAPanelDoesNotTeleport) {
    for (Hand& hand : hands) hand.has_stick = false;
    free = {FreeHand{false, false}, FreeHand{false, false}};
    hands[right_hand].select = true;
    step();
    free = {};  // the ray left the panel
    step();
    EXPECT_FALSE(w.aiming);
    hands[right_hand].select = false;
    step();
    hands[right_hand].select = true;
    step();
    EXPECT_TRUE(w.aiming);
}

TEST_F(LocomotionTest, HandThatIsLostWhileAimingGoesNowhere) {
    surface = floor_at(0);
    const Stance before = w.stance;
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc);
    hands[right_hand] = {};
    step();
    EXPECT_FALSE(w.arc);
    EXPECT_EQ(w.stance.at, before.at);
    EXPECT_EQ(w.stance.R, before.R);
}

TEST_F(LocomotionTest, StickThatIsPushedAlreadyDoesNothingUntilItIsLetGo) {
    surface = floor_at(0);
    const Stance before = w.stance;
    free[right_hand].move = false;  // the stick scrolls a list
    stick(right_hand, 0, 1);
    step();
    free = {};  // the ray left the panel
    step();
    EXPECT_FALSE(w.aiming);
    stick(left_hand, 0, 1);  // flies
    hands[right_hand] = {};  // the other controller goes to sleep
    step();
    EXPECT_FALSE(w.aiming);
    stick(left_hand, 0, 0);
    step();
    stick(left_hand, 0, 1);
    step();
    EXPECT_EQ(w.aiming, left_hand);
    EXPECT_EQ(w.stance.R, before.R);
}

TEST_F(LocomotionTest, TurnWhileAHandHoldsTheSceneStays) {
    hands[left_hand].squeeze = true;
    step(3);
    const Vector3d before = ahead();
    stick(right_hand, 1, 0);
    step(3);
    EXPECT_NEAR(std::acos(before.dot(ahead())), std::numbers::pi / 6, 1e-9);
    const Vector3d there = eye();
    w.stance = moved(w.stance, {3, 2, 1});  // moved by a command
    step(3);
    EXPECT_LT((eye() - there - Vector3d(3, 2, 1)).norm(), 1e-9);
}

TEST_F(LocomotionTest, CeilingIsNoPlaceToStand) {
    // The ceiling and the floor are visible from either side, like a mesh.
    surface = [](const Vector3d& from, const Vector3d& to) -> std::optional<SurfacePoint> {
        for (const double z : {20.0, 0.0}) {
            if ((from.z() - z) * (to.z() - z) > 0 || from.z() == to.z()) continue;
            const Vector3d at = from + (to - from) * ((from.z() - z) / (from.z() - to.z()));
            return SurfacePoint{at, Vector3d(0, 0, from.z() < to.z() ? -1 : 1)};
        }
        return {};
    };
    hands[right_hand].aim = aiming({0.2, 1.2, -0.3}, 1.2);
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc && w.arc->landing);
    EXPECT_NEAR(w.arc->landing->z(), 0, 1e-9) << "the user lands on the floor below the ceiling";
}

TEST_F(LocomotionTest, LettingGoOfWhatHandsBeganHasNoEffect) {
    surface = floor_at(0);
    const Stance before = w.stance;
    stick(right_hand, 0, 1);
    step();
    ASSERT_TRUE(w.arc);
    let_go(w);
    hands = {};
    continue_locomotion(w, with_gaze(hands, head, false, false), free, head, frame, surface);
    EXPECT_EQ(w.stance.at, before.at);
}

TEST_F(LocomotionTest, GazeAndAButtonReplaceHands) {
    surface = floor_at(0);
    head = aiming({0.2, 1.6, 0.1}, -35 * std::numbers::pi / 180);
    hands = {};
    EXPECT_FALSE(any_points(hands));
    const auto gaze = [&](bool button) {
        continue_locomotion(w, with_gaze(hands, head, button, false), free, head, frame, surface);
    };
    gaze(false);
    gaze(true);
    ASSERT_TRUE(w.arc && w.arc->landing);
    const Vector3d there = *w.arc->landing;
    gaze(false);
    EXPECT_LT((in_scene(w.stance, {head.at.x(), 0, head.at.z()}) - there).norm(), 1e-9);
    hands[left_hand].select = true;  // a remote that is held, but not tracked
    EXPECT_TRUE(with_gaze(hands, head, false, false)[right_hand].select);
}

}  // namespace
}  // namespace vantage
