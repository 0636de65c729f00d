#pragma once
#include <optional>

#include "base/gl/context.h"
#include "base/gl/object.h"
#include "player/options/show_options.h"
#include "player/view/frame_size.h"
#include "player/window/glfw_window.h"

namespace vantage {

struct MirrorButtons {
    bool select = false, menu = false;
};

/// The OpenGL context for a headset. The context belongs to a window that mirrors the headset's picture, or
/// has no window if there is no X display.
class Mirror {
  public:
    explicit Mirror(const ShowOptions& options);
    /// Copies a picture into the window, at a limited rate.
    void show(GLuint framebuffer, FrameSize size);
    /// Handles events and shows the copied picture.
    void attend();
    /// Buttons held down in the window: the left button or Space selects, the right button or M opens the
    /// menu.
    MirrorButtons buttons() const;
    bool closed() const;

  private:
    std::optional<GlfwWindow> window_;
    std::optional<gl::HeadlessContext> context_;
    double shown_at_ = -1;
    bool copied_ = false;
};

}  // namespace vantage
