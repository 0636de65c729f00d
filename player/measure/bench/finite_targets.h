#pragma once
#include <cstddef>
#include <string>

#include "player/render/passes/frame_targets.h"

namespace vantage {

/// The number of infinite and NaN values in a frame's float targets. A picture hides them: conversion to 8
/// bits clamps them.
struct NonFinite {
    std::size_t depth = 0, surface = 0, sums = 0, samples = 0;
    std::size_t all() const { return depth + surface + sums + samples; }
};
/// Counts in the last frame. Waits and reads all targets back, so it is only for verification.
NonFinite count_non_finite(const FrameTargets& targets);

/// A message, in one line.
std::string words(const NonFinite& found);

}  // namespace vantage
