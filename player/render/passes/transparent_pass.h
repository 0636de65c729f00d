#pragma once
#include <cstdint>
#include <functional>

#include "base/gl/object.h"
#include "base/gl/readback.h"
#include "player/render/passes/frame_targets.h"
#include "player/render/render_settings.h"

namespace vantage {

/// Fragments of transparent surfaces.
struct FragmentCount {
    std::size_t fragments = 0;     ///< fragments in front of opaque surfaces
    std::size_t approximated = 0;  ///< fragments that were not sorted, for lack of space
};

/// The buffers in which transparent surfaces are collected: weighted sums (McGuire and Bavoil 2013) and, in
/// exact mode, a list of fragments per pixel (Yang et al. 2010), which the resolve pass sorts. Must be used
/// on the OpenGL thread.
class TransparentPass {
  public:
    /// Average capacity of lists, in fragments per pixel; further fragments are added to the sums.
    static constexpr std::uint64_t layers_per_pixel = 4;
    /// Maximum size of the lists, in bytes.
    static constexpr std::uint64_t max_list_bytes = std::uint64_t(512) << 20;

    /// `list_bytes`: graphics memory for lists.
    explicit TransparentPass(std::uint64_t list_bytes) : list_bytes_(list_bytes) {}
    void release();
    /// Creates the buffers for frames of at most the targets' allocated size, with a copy of the model's
    /// depth. Does nothing if the mode is off.
    void fit(const FrameTargets& targets, Transparency mode);
    std::uint64_t bytes(int width, int height, Transparency mode) const;
    /// The mode with which fit() was last called.
    Transparency mode() const { return mode_; }
    /// Capacity of the lists, in fragments.
    std::uint32_t capacity() const { return capacity_; }

    /// Row stride of the lists' heads, in pixels.
    int row() const { return allocated_.width; }

    /// Calls `draw` with empty targets and lists bound, and a depth test against the frame's depth.
    void collect(FrameSize frame, const std::function<void()>& draw);
    /// Binds the collected data as the input of the resolve pass.
    void bind() const;
    /// Starts reading back the number of fragments, after the resolve pass. Does nothing while an earlier
    /// count is in flight.
    void capture();
    /// Takes a count that has arrived; with `wait`, waits for a count in flight. Returns whether there is a
    /// new count.
    bool update(bool wait);
    const FragmentCount& count() const { return count_; }

  private:
    std::uint32_t capacity_for(int width, int height) const;

    std::uint64_t list_bytes_;
    Transparency mode_ = Transparency::off;
    FrameSize allocated_;
    std::uint32_t capacity_ = 0;
    gl::Texture sums_, transmitted_;
    gl::Framebuffer target_;
    gl::Buffer heads_, fragments_;
    gl::Readback counts_;
    FragmentCount count_;
};

}  // namespace vantage
