#pragma once
#include <cstdint>

#include "gl/object.h"

namespace vantage {

/// What a frame is drawn into: the bare surface with its depth and its triangles' numbers (from 1), two float
/// targets of sums (best photo and consensus read one while they write the other), and the samples added up.
struct FrameTargets {
    int width = 0, height = 0;
    bool half_sums = false;
    gl::Texture depth, surface, triangles, sums[2], accumulated;
    gl::Framebuffer surface_target, sums_target[2], accumulated_target;

    static std::uint64_t bytes(int width, int height, bool half_sums);
};

/// Throws Error(usage) when the size is beyond what the graphics card draws.
/// `half_sums`: sums in half precision.
FrameTargets make_frame_targets(int width, int height, bool half_sums);

}  // namespace vantage
