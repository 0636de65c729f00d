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

/// The OpenGL context for a headset: that of a window, which shows what is seen there, or one without a
/// window where there is no X display.
class Mirror {
  public:
    explicit Mirror(const ShowOptions& options);
    /// Copies a picture into the window, now and then.
    void show(GLuint framebuffer, FrameSize size);
    /// Handles events; shows what was copied.
    void attend();
    /// What is held down in the window: the left button or Space selects, the right one or M is the menu.
    MirrorButtons buttons() const;
    bool closed() const;

  private:
    std::optional<GlfwWindow> window_;
    std::optional<gl::HeadlessContext> context_;
    double shown_at_ = -1;
    bool copied_ = false;
};

}  // namespace vantage
