#pragma once
#include <cstddef>
#include <string>

#include "player/render/passes/frame_targets.h"

namespace vantage {

/// The number of infinite and NaN values in a frame's float targets. Such values are not visible in pictures,
/// because the conversion to 8 bits clamps them.
struct NonFinite {
    std::size_t depth = 0, surface = 0, sums = 0, samples = 0;
    std::size_t all() const { return depth + surface + sums + samples; }
};
/// Counts infinite and NaN values in the last frame. Use it only for verification, because it waits for the
/// GPU and reads back all targets.
NonFinite count_non_finite(const FrameTargets& targets);

/// A one-line message.
std::string words(const NonFinite& found);

}  // namespace vantage
