#pragma once
#include <array>
#include <optional>

#include "player/headset/locomotion/hands.h"
#include "player/headset/locomotion/stance.h"
#include "player/headset/locomotion/teleport_arc.h"

namespace vantage {

/// How somebody in a headset moves about.
struct Locomotion {
    Stance stance;
    double usual_scale = 1;    ///< scene units per meter; hands change it by up to max_scaling
    bool smooth = true;        ///< a stick flies; otherwise one only teleports
    double snap_degrees = 30;  ///< per turn

    std::optional<Hold> hold{};
    std::array<bool, 2> holds{};          ///< which hands
    Stance held_at{};                     ///< the stance that the hold led to
    std::optional<std::size_t> aiming{};  ///< the hand whose arc is shown
    std::optional<TeleportArc> arc{};     ///< of that hand
    std::array<bool, 2> selected{};       ///< in the last frame
    std::array<bool, 2> ready{};          ///< sticks that have been in the middle since they got their use
    double vignette = 0;                  ///< 0: the whole picture is shown, 1: its middle
};
inline constexpr double max_scaling = 200;

/// What a hand may do here. One that points at a panel may do neither; selecting may have another use.
struct FreeHand {
    bool move = true;    ///< stick and squeezing
    bool select = true;  ///< for teleporting, without a stick
};
using FreeHands = std::array<FreeHand, 2>;

/// Moves on by a frame, after `seconds`. The stick of the right hand, or the only one: to the side turns by a
/// step; ahead aims an arc and, let go, teleports to its end. The other stick flies where its hand points.
/// Without a stick, select aims. A stick that was pushed already, when it got its use, has to be let go
/// first. Squeezing holds the scene: one hand moves it, two also turn and scale it.
void continue_locomotion(Locomotion& locomotion, const Hands& hands, const FreeHands& free,
                         const RoomPose& head, double seconds, const SurfaceBetween& surface);

/// Ends what the hands began, without effect: they are gone, or others have come.
void let_go(Locomotion& locomotion);

}  // namespace vantage
