#pragma once
#include <vector>

#include "base/gl/object.h"
#include "player/headset/runtime/openxr.h"
#include "player/view/frame_size.h"

namespace vantage {

/// The runtime's pictures for one eye, colors or depth. Move-only. Use it only on the OpenGL thread; it must
/// not outlive the session.
class EyeSwapchain {
  public:
    /// `format`: an OpenGL format; `depth`: depth instead of colors. Throws Error(graphics) or XrLost.
    EyeSwapchain(XrSession session, FrameSize size, std::int64_t format, bool depth);
    ~EyeSwapchain();
    EyeSwapchain(EyeSwapchain&& other) noexcept;
    EyeSwapchain& operator=(EyeSwapchain&&) = delete;

    /// Acquires an image to draw into, waiting until the runtime no longer needs it.
    void acquire();
    /// The framebuffer of the last acquired image.
    GLuint target() const { return targets_.at(taken_).id(); }
    /// Releases the image; it is shown with the next frame that ends.
    void release();
    XrSwapchain get() const { return swapchain_; }
    FrameSize size() const { return size_; }

  private:
    XrSwapchain swapchain_ = XR_NULL_HANDLE;
    FrameSize size_;
    bool acquired_ = false;
    std::uint32_t taken_ = 0;
    std::vector<gl::Framebuffer> targets_;  ///< per image
};

/// The color format among those that the runtime offers: sRGB with 8 bits. Throws Error(graphics) if the
/// runtime does not offer it.
std::int64_t color_format(XrSession session);
/// The depth format among those that the runtime offers; 0 if it offers none.
std::int64_t depth_format(XrSession session);

}  // namespace vantage
