#pragma once
#include <vector>

#include "player/interface/state/user_input.h"

namespace vantage {

/// What is dragged and let go in motion moves on, slower and slower.
struct Glide {
    struct Movement {
        double at;  ///< seconds
        Drags drags;
    };
    bool held = false;             ///< by a mouse button or a finger
    std::vector<Movement> recent;  ///< of the frames while it is held
    Drags ahead{};                 ///< how far it still moves, pixels
    double at = 0;                 ///< of the last frame, seconds
};

/// How far what was dragged by `drags` moves in the frame at `now`, in seconds; without an end to it being
/// held, by as much. It is let go in motion if it moved in two frames of the last tenth of a second, faster
/// than 50 pixels per second, and moves on for the distance of the next quarter of a second at that speed.
Drags move_on(Glide& glide, const Drags& drags, bool held, double now);

}  // namespace vantage
