#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/gl/object.h"
#include "player/render/render_settings.h"

namespace vantage {

/// The one of a pixel's side * side samples that a frame draws, or all of them.
struct PixelSample {
    int index = 0, side = 1;
    bool all = false;
    /// Samples per side of a pixel that the frame draws.
    int drawn() const { return all ? side : 1; }
};

/// Samples of frames that draw one each, `side` * `side` together.
std::vector<PixelSample> single_samples(int side);

/// A frame to draw.
struct FrameRequest {
    std::span<const View> eyes;  ///< of one eye or two, of the same size
    const RenderSettings& settings;
    /// Indices. Held-out photos are skipped, and those of image sets that are not shown.
    std::span<const std::uint32_t> photos;
    PixelSample sample{};        ///< added to the samples drawn since sample 0, unless they are all
    double now = 0;              ///< seconds, for fading
    const View* next = nullptr;  ///< the view expected soon, to prefetch for
};

/// Where a picture is shown.
struct ShowTarget {
    GLuint framebuffer;
    bool flip = false;    ///< its first row is at the bottom, as a window's is
    std::size_t eye = 0;  ///< whose picture is shown
};

/// Keeps non-finite values, and values whose square overflows single precision, from the shaders. Throws
/// Error(usage).
void check_view(const View& view);

}  // namespace vantage
