#pragma once
#include <vector>

#include "player/interface/state/user_input.h"

namespace vantage {

/// Inertia: a drag that is released while moving continues and slows down.
struct Glide {
    struct Movement {
        double at;  ///< seconds
        Drags drags;
    };
    bool held = false;             ///< held by a mouse button or a finger
    std::vector<Movement> recent;  ///< movements in the frames of the drag
    Drags ahead{};                 ///< remaining movement, pixels
    double at = 0;                 ///< time of the last frame, seconds
};

/// Movement in the frame at `now` (seconds) for the input `drags`; while the drag is held, it equals `drags`.
/// A drag glides if, in the last tenth of a second before its release, it moved in at least two frames and
/// faster than 50 pixels per second. The drag then continues for the distance that it would cover in a
/// quarter of a second at that speed.
Drags move_on(Glide& glide, const Drags& drags, bool held, double now);

}  // namespace vantage
