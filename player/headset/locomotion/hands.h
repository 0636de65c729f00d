#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

#include "player/headset/locomotion/room_pose.h"

namespace vantage {

/// State of a hand, with or without a controller, in one frame.
struct Hand {
    std::optional<RoomPose> aim;   ///< pointing ray; nullopt: not tracked
    std::optional<RoomPose> grip;  ///< position and orientation
    bool select = false;           ///< trigger, or pinch
    bool squeeze = false;
    bool menu = false, has_menu = false;  ///< has_menu: whether there is a menu button
    bool has_stick = false;
    Eigen::Vector2d stick = Eigen::Vector2d::Zero();  ///< right and forward: -1 to 1
};

/// The left and the right hand.
using Hands = std::array<Hand, 2>;
inline constexpr std::size_t left_hand = 0, right_hand = 1;

/// Whether any hand has a pointing ray.
inline bool any_points(const Hands& hands) { return hands[left_hand].aim || hands[right_hand].aim; }

/// Input without tracked controllers: the right hand points where the head looks. Either hand's select button
/// or `select` selects; either hand's menu button or `menu` opens the menu.
inline Hands with_gaze(Hands hands, const RoomPose& head, bool select, bool menu) {
    Hand& hand = hands[right_hand];
    hand.aim = head;
    hand.select |= hands[left_hand].select || select;
    hand.menu |= hands[left_hand].menu || menu;
    hands[left_hand] = {};
    return hands;
}

}  // namespace vantage
