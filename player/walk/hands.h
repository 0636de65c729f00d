#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>

#include "player/walk/room_pose.h"

namespace vantage {

/// What a hand does, with a controller or without, in one frame.
struct Hand {
    std::optional<RoomPose> aim;   ///< where it points; nothing: not tracked
    std::optional<RoomPose> grip;  ///< where it is
    bool select = false;           ///< trigger, or pinch
    bool squeeze = false;
    bool menu = false;
    bool has_stick = false;
    Eigen::Vector2d stick = Eigen::Vector2d::Zero();  ///< right, ahead: -1 to 1
};

/// The left and the right one.
using Hands = std::array<Hand, 2>;
inline constexpr std::size_t left_hand = 0, right_hand = 1;

}  // namespace vantage
