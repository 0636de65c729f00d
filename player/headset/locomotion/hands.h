#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

#include "player/headset/locomotion/room_pose.h"

namespace vantage {

/// What a hand does, with a controller or without, in one frame.
struct Hand {
    std::optional<RoomPose> aim;   ///< where it points; nothing: not tracked
    std::optional<RoomPose> grip;  ///< where it is
    bool select = false;           ///< trigger, or pinch
    bool squeeze = false;
    bool menu = false, has_menu = false;  ///< has: there is a button for it
    bool has_stick = false;
    Eigen::Vector2d stick = Eigen::Vector2d::Zero();  ///< right, ahead: -1 to 1
};

/// The left and the right one.
using Hands = std::array<Hand, 2>;
inline constexpr std::size_t left_hand = 0, right_hand = 1;

/// Whether a hand points anywhere.
inline bool any_points(const Hands& hands) { return hands[left_hand].aim || hands[right_hand].aim; }

/// What somebody does who has no controller, or one that is not tracked: the right hand points where the head
/// looks; any button that there is selects, and so does `select`; `menu` likewise.
inline Hands with_gaze(Hands hands, const RoomPose& head, bool select, bool menu) {
    Hand& hand = hands[right_hand];
    hand.aim = head;
    hand.select |= hands[left_hand].select || select;
    hand.menu |= hands[left_hand].menu || menu;
    hands[left_hand] = {};
    return hands;
}

}  // namespace vantage
