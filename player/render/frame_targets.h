#pragma once
#include <cstdint>

#include "gl/object.h"
#include "player/camera/frame_size.h"

namespace vantage {

/// The render targets of a frame: the bare surface with its depth and the numbers of its triangles (from 1),
/// the picture of photos that others are replacing, two float targets of sums (best photo and consensus read
/// one and write the other), and accumulated samples. They may have room for larger frames.
struct FrameTargets {
    int width = 0, height = 0;  ///< of the frame, pixels; up to `room`
    FrameSize room;             ///< of the textures
    bool half_sums = false;
    gl::Texture depth, surface, triangles, sums[2], before, accumulated;
    gl::Framebuffer surface_target, sums_target[2], before_target, accumulated_target;
    gl::Texture other;  ///< samples of a second band; see add_other
    gl::Framebuffer other_target;

    /// Makes `other` if it is not there; all 0.
    void add_other();
    static std::uint64_t bytes(int width, int height, bool half_sums);
};

/// For frames of at most this size. `half_sums`: sums in half floats. Throws Error(usage) for a size that the
/// graphics card cannot draw.
FrameTargets make_frame_targets(FrameSize room, bool half_sums);

}  // namespace vantage
