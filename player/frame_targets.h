#pragma once
#include "gl/object.h"

namespace vantage {

/// What a frame is drawn into, at the size of its samples: the bare surface with its depth, and two float
/// targets of sums (best photo reads one while it writes the other).
struct FrameTargets {
    int width = 0, height = 0;
    gl::Texture depth, surface, sums[2];
    gl::Framebuffer surface_target, sums_target[2];
};

/// Throws Error(usage) when the size is beyond what the graphics card draws.
FrameTargets make_frame_targets(int width, int height);

}  // namespace vantage
