#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/gl/object.h"
#include "base/gl/readback.h"
#include "player/plan/views/seen_triangles.h"
#include "player/plan/visible_surface.h"
#include "player/render/passes/frame_targets.h"
#include "player/view/view.h"

namespace vantage {

/// Reads back the triangles that are visible in a frame (see Seen), without waiting for the graphics card
/// unless requested. With these triangles, plans cover only the visible surface, not hidden parts.
class TriangleReadback {
  public:
    /// Graphics memory needed for frames of this size.
    static std::uint64_t bytes(FrameSize frame) {
        const FrameSize samples = Seen::samples(frame);
        return std::uint64_t(samples.width + 1) * std::uint64_t(samples.height + 1) * 8;
    }
    /// Frees the graphics memory until the next capture.
    void release();
    /// Starts reading the triangles of `view` in `targets`. Does nothing while an earlier frame is in flight.
    void capture(const FrameTargets& targets, const View& view);
    /// Takes the triangles that have arrived; with `wait`, waits for those in flight. Returns whether the
    /// triangles have changed. Numbers above `triangles`, the scene's count, belong to triangles of a coarse
    /// mesh; they are mapped to the scene's triangles in `stands_for`, which the coarse triangles replace.
    bool update(bool wait, std::size_t triangles, std::span<const std::uint32_t> stands_for);

    /// The result is valid as long as the caller holds it.
    SeenTriangles seen() const { return {triangles_, view_, version_}; }

  private:
    FrameSize allocated_;  ///< of `small_`
    std::size_t captured_pixels_ = 0;
    gl::Texture small_;
    gl::Framebuffer small_target_;
    gl::Readback pixels_;
    View view_{}, captured_{};
    using Numbers = std::shared_ptr<std::vector<std::uint32_t>>;
    Numbers unused();

    Numbers triangles_;
    std::vector<Numbers> others_;  ///< either held by plans or unused
    std::uint64_t version_ = 0;
};

}  // namespace vantage
