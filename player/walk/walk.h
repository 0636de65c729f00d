#pragma once
#include <array>
#include <optional>

#include "player/walk/hands.h"
#include "player/walk/stance.h"
#include "player/walk/teleport_arc.h"

namespace vantage {

/// How somebody in a headset moves about.
struct Walk {
    Stance stance;
    double usual_scale = 1;    ///< scene units per meter; hands change it by up to most_scaling
    bool smooth = true;        ///< a stick flies; otherwise one only teleports
    double snap_degrees = 30;  ///< per turn

    std::optional<Hold> hold{};
    std::array<bool, 2> holds{};          ///< which hands
    std::optional<std::size_t> aiming{};  ///< the hand whose arc is shown
    std::optional<TeleportArc> arc{};     ///< of that hand
    std::array<bool, 2> selected{};       ///< in the last frame
    bool turning = false;                 ///< the stick is still to the side
    double vignette = 0;                  ///< 0: the whole picture is shown, 1: its middle
};
inline constexpr double most_scaling = 200;

/// Which hands may move; one that points at a panel does not.
using FreeHands = std::array<bool, 2>;

/// Moves on by a frame, after `seconds`. The stick of the right hand, or the only one: to the side turns by a
/// step; ahead aims an arc and, let go, teleports to its end. The other stick flies where its hand points.
/// Without a stick, select aims. Squeezing holds the scene: one hand moves it, two also turn and scale it.
void walk_on(Walk& walk, const Hands& hands, const FreeHands& free, const RoomPose& head, double seconds,
             const SurfaceBetween& surface);

}  // namespace vantage
