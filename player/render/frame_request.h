#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/gl/object.h"
#include "player/render/render_settings.h"

namespace vantage {

/// One of a pixel's side * side samples, or all of them.
struct PixelSample {
    int index = 0, side = 1;
    bool all = false;
    /// Samples per side of a pixel in this frame.
    int drawn() const { return all ? side : 1; }
};

/// Samples of successive frames with one sample each, `side` * `side` in total.
std::vector<PixelSample> single_samples(int side);

/// A frame to draw.
struct FrameRequest {
    std::span<const View> eyes;  ///< one or two eyes, of the same size
    const RenderSettings& settings;
    /// Indices. Held-out photos and those of hidden image sets are skipped.
    std::span<const std::uint32_t> photos;
    PixelSample sample{};        ///< added to the samples drawn since sample 0, unless all are drawn at once
    double now = 0;              ///< seconds, for fading
    const View* next = nullptr;  ///< the next expected view, for prefetching
};

/// Destination of a picture.
struct ShowTarget {
    GLuint framebuffer;
    bool flip = false;    ///< its first row is at the bottom, as in a window
    std::size_t eye = 0;  ///< the eye whose picture is shown
};

/// Rejects views that contain non-finite values, or values whose square overflows single precision. Throws
/// Error(usage).
void check_view(const View& view);

}  // namespace vantage
