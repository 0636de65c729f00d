#include "player/headset/locomotion/stance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vantage {
namespace {

using Eigen::Vector3d;

RoomPose looking(const Vector3d& at, double left, double up = 0) {
    return {Eigen::Quaterniond(Eigen::AngleAxisd(left, Vector3d::UnitY()) *
                               Eigen::AngleAxisd(up, Vector3d::UnitX())),
            at};
}

/// A rotated, moved and scaled stance in a scene whose up direction is not along an axis.
Stance some_stance() {
    return standing(looking({0.3, 1.6, -0.2}, 0.7), {12, -3, 4}, {2, 5, 1}, Vector3d(1, 2, 5).normalized(),
                    40);
}

TEST(Stance, HeadStandsAtTheEyeAndLooksAtTheTargetWhereverItIsInTheRoom) {
    const Vector3d eye(12, -3, 4), target(2, 5, 1), up(0, 0, 1);
    for (const double left : {0.0, 0.7, -2.9, 3.1}) {
        const RoomPose head = looking({0.3, 1.6, -0.2}, left, 0.2);
        const Stance s = standing(head, eye, target, up, 40);
        EXPECT_LT((in_scene(s, head.at) - eye).norm(), 1e-12);
        const Vector3d ahead = s.R * head.ahead();
        const Vector3d level = (ahead - up * up.dot(ahead)).normalized();
        const Vector3d wanted = (target - eye - up * up.dot(target - eye)).normalized();
        EXPECT_GT(level.dot(wanted), 1 - 1e-12) << left;
        EXPECT_LT((s.up() - up).norm(), 1e-12) << "the view is level although the head looks up";
        EXPECT_NEAR((in_scene(s, {1, 0, 0}) - in_scene(s, {0, 0, 0})).norm(), 40, 1e-9);
        EXPECT_NEAR(s.R.determinant(), 1, 1e-12);
    }
}

TEST(Stance, TargetStraightAboveIsNoTrouble) {
    for (const Vector3d& target : {Vector3d(0, 0, 9), Vector3d(0, 0, -9), Vector3d(0, 0, 0)}) {
        const Stance s =
            standing(looking({0, 1.6, 0}, 0, -std::numbers::pi / 2), {0, 0, 0}, target, Vector3d::UnitZ(), 1);
        EXPECT_TRUE(s.R.allFinite() && s.at.allFinite());
        EXPECT_TRUE((s.R * s.R.transpose()).isIdentity(1e-12));
    }
}

TEST(Stance, PlacesInTheRoomAreThoseOfTheSceneAndBack) {
    const Stance s = some_stance();
    for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(1, 2, -3)})
        EXPECT_LT((in_room(s, in_scene(s, p)) - p).norm(), 1e-12);
}

TEST(Stance, TurningLeavesTheHeadInItsPlace) {
    const Stance s = some_stance();
    const RoomPose head = looking({0.8, 1.7, 0.4}, -1);
    const Stance left = turned(s, head, std::numbers::pi / 6);
    EXPECT_LT((in_scene(left, head.at) - in_scene(s, head.at)).norm(), 1e-12);
    const Vector3d before = s.R * head.ahead(), after = left.R * head.ahead();
    EXPECT_NEAR(before.cross(after).dot(s.up()), std::sin(std::numbers::pi / 6), 1e-12) << "to the left";
}

TEST(Stance, TeleportingPutsTheFeetOnThePointBelowTheHead) {
    const Stance s = some_stance();
    const RoomPose head = looking({0.8, 1.7, 0.4}, -1);
    const Vector3d floor(100, 50, -7);
    const Stance there = stood_on(s, head, floor);
    EXPECT_LT((in_scene(there, head.at) - (floor + s.up() * 1.7 * s.scale)).norm(), 1e-9);
    EXPECT_TRUE(there.R == s.R);
}

TEST(Stance, WhatOneHandHoldsFollowsItWithoutTurning) {
    const Stance s = some_stance();
    const Hold hold{s, {Vector3d(0.2, 1.2, -0.5), {}}, 1};
    const Vector3d now(0.5, 0.9, -0.1);
    const Stance after = held(hold, std::span(&now, 1), 1e-3, 1e3);
    EXPECT_LT((in_scene(after, now) - in_scene(s, hold.hands[0])).norm(), 1e-12);
    EXPECT_TRUE(after.R == s.R);
    EXPECT_EQ(after.scale, s.scale);
}

TEST(Stance, WhatTwoHandsHoldStaysInBothWhenTheyTurnMoveAndSpread) {
    const Stance s = some_stance();
    const Vector3d left(-0.2, 1.2, -0.4), right(0.3, 1.2, -0.6);
    const Hold hold{s, {left, right}, 2};
    // Both hands are moved by a rotation about up, a scaling and a translation.
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.9, Vector3d::UnitY()).toRotationMatrix();
    const auto moved_hand = [&](const Vector3d& p) -> Vector3d {
        return 1.7 * (turn * p) + Vector3d(0.1, -0.3, 0.2);
    };
    const std::array<Vector3d, 2> now{moved_hand(left), moved_hand(right)};
    const Stance after = held(hold, now, 1e-3, 1e3);
    EXPECT_NEAR(after.scale, s.scale / 1.7, 1e-9);
    EXPECT_LT((in_scene(after, now[0]) - in_scene(s, left)).norm(), 1e-9);
    EXPECT_LT((in_scene(after, now[1]) - in_scene(s, right)).norm(), 1e-9);
}

TEST(Stance, HandsThatTouchOrAreAboveEachOtherDoNotSpinTheScene) {
    const Stance s = some_stance();
    const Vector3d at(0, 1.2, -0.4);
    for (const Vector3d& span : {Vector3d(0, 0, 0), Vector3d(0, 0.4, 0), Vector3d(1e-9, 0, 1e-9)}) {
        const Hold hold{s, {at, at + span}, 2};
        for (const Vector3d& now : {span, Vector3d(-span), Vector3d(0, 0, 0)}) {
            const std::array<Vector3d, 2> hands{at, at + now};
            const Stance after = held(hold, hands, 1e-3, 1e3);
            EXPECT_TRUE(after.R == s.R);
            EXPECT_TRUE(after.at.allFinite());
            EXPECT_GT(after.scale, 0);
        }
    }
}

TEST(Stance, ScaleStaysWithinItsLimits) {
    const Hold hold{some_stance(), {Vector3d(0, 0, 0), Vector3d(0.03, 0, 0)}, 2};
    const std::array<Vector3d, 2> wide{Vector3d(0, 0, 0), Vector3d(2, 0, 0)};
    EXPECT_EQ(held(hold, wide, 20, 80).scale, 20);
    const Hold far{some_stance(), {Vector3d(0, 0, 0), Vector3d(2, 0, 0)}, 2};
    const std::array<Vector3d, 2> near{Vector3d(0, 0, 0), Vector3d(0.03, 0, 0)};
    EXPECT_EQ(held(far, near, 20, 80).scale, 80);
}

}  // namespace
}  // namespace vantage
