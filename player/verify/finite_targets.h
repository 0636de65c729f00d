#pragma once
#include <cstddef>
#include <string>

#include "player/render/frame_targets.h"

namespace vantage {

/// How many values of a frame's float targets are infinite or no number. A picture hides them: they are
/// clamped on the way to 8 bits.
struct NonFinite {
    std::size_t depth = 0, surface = 0, sums = 0, samples = 0;
    std::size_t all() const { return depth + surface + sums + samples; }
};
/// Of what was drawn last. Waits, and reads everything back: to look for errors.
NonFinite count_non_finite(const FrameTargets& targets);

/// For people, in one line.
std::string words(const NonFinite& found);

}  // namespace vantage
