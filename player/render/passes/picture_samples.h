#pragma once
#include <cstdint>

#include "base/gl/object.h"
#include "player/view/frame_size.h"

namespace vantage {

/// Sums of a picture's samples: light times coverage, and coverage. A second image set has its own sum. Where
/// holes are filled behind transparent surfaces, `veil` holds the surfaces over the holes, and `clean` the
/// samples without those surfaces, from which the holes are filled.
struct PictureSamples {
    FrameSize allocated;  ///< of the textures
    gl::Texture sum, other, veil, clean;
    gl::Framebuffer sum_target, other_target, veiled_target;
    double count = 0;  ///< per pixel

    /// Allocates `other`, filled with zeros, if necessary.
    void add_other();
    /// Allocates `veil` and `clean` if necessary. `veiled_target` writes both of them and `sum`.
    void add_veil();
    static std::uint64_t bytes(int width, int height) {
        return 16 * std::uint64_t(width) * std::uint64_t(height);
    }
    /// Size of `veil` and `clean`.
    static std::uint64_t veil_bytes(int width, int height) {
        return (8 + 16) * std::uint64_t(width) * std::uint64_t(height);
    }
};

PictureSamples make_picture_samples(FrameSize allocated);

}  // namespace vantage
