#pragma once
#include <array>
#include <optional>

#include "player/headset/locomotion/hands.h"
#include "player/headset/locomotion/stance.h"
#include "player/headset/locomotion/teleport_arc.h"

namespace vantage {

/// State of the user's locomotion in a headset.
struct Locomotion {
    Stance stance;
    /// Scene units per meter. The hands change the scale by at most a factor of max_scaling.
    double usual_scale = 1;
    bool smooth = true;        ///< whether sticks fly; if not, users only teleport
    double snap_degrees = 30;  ///< per turn

    std::optional<Hold> hold{};
    std::array<bool, 2> holds{};          ///< which hands
    Stance held_at{};                     ///< stance at the last update of the hold
    std::optional<std::size_t> aiming{};  ///< the hand that shows an arc
    std::optional<TeleportArc> arc{};     ///< of that hand
    std::array<bool, 2> selected{};       ///< whether each hand selected in the last frame
    std::array<bool, 2> ready{};          ///< sticks that have been centered since they became active
    double vignette = 0;                  ///< 0: off, 1: only the center is visible
};
inline constexpr double max_scaling = 200;

/// Functions available to a hand; none are available while it points at a panel. `select` is false while
/// selecting has another use.
struct FreeHand {
    bool move = true;    ///< stick and squeeze
    bool select = true;  ///< teleporting by selecting, without a stick
};
using FreeHands = std::array<FreeHand, 2>;

/// Advances by one frame, after `seconds`. The right (or only) stick turns the user in steps if moved
/// sideways; while pushed forward it aims an arc, and when released it teleports to the arc's end. The other
/// stick moves the user in the direction in which its hand points. Without a stick, the select button aims. A
/// stick that was already deflected when it became active must be released first. Squeezing grabs the scene:
/// one hand moves the scene, and two hands also turn and scale it.
void continue_locomotion(Locomotion& locomotion, const Hands& hands, const FreeHands& free,
                         const RoomPose& head, double seconds, const SurfaceBetween& surface);

/// Cancels the current actions of the hands after tracking has been lost or the hands have changed.
void let_go(Locomotion& locomotion);

}  // namespace vantage
