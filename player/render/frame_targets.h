#pragma once
#include <cstdint>
#include <vector>

#include "gl/object.h"
#include "player/camera/frame_size.h"
#include "player/render/picture_samples.h"

namespace vantage {

/// The render targets of a frame: the bare surface with its depth and the numbers of its triangles (from 1),
/// the picture of photos that others are replacing, two float targets of sums (best photo and consensus read
/// one and write the other), and the samples of each eye's picture. They may have room for larger frames.
struct FrameTargets {
    int width = 0, height = 0;  ///< of the frame, pixels; up to `room`
    FrameSize room;             ///< of the textures
    bool half_sums = false;
    gl::Texture depth, surface, triangles, sums[2], before;
    gl::Framebuffer surface_target, sums_target[2], before_target;
    std::vector<PictureSamples> samples;  ///< per eye

    static std::uint64_t bytes(int width, int height, bool half_sums, std::size_t eyes = 1);
};

/// For frames of at most this size, drawn for one eye or two. `half_sums`: sums in half floats. Throws
/// Error(usage) for a size that the graphics card cannot draw.
FrameTargets make_frame_targets(FrameSize room, bool half_sums, std::size_t eyes = 1);

}  // namespace vantage
