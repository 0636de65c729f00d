#pragma once
#include <memory>
#include <vector>

#include "player/window/input/fingers.h"

struct GLFWwindow;

namespace vantage {

/// The touch screen under a window, of which GLFW knows only the first finger, as a mouse. Needs X11 with
/// XInput 2.2; elsewhere there is none, and that finger stays a mouse.
class TouchScreen {
  public:
    /// Listens on a thread of its own, which wakes the window's thread from waiting for events.
    explicit TouchScreen(GLFWwindow* window);
    ~TouchScreen();
    TouchScreen(const TouchScreen&) = delete;
    TouchScreen& operator=(const TouchScreen&) = delete;
    /// What has happened since it was last asked, in order.
    std::vector<TouchEvent> take();

  private:
    struct Listener;
    std::unique_ptr<Listener> listener_;  ///< empty: no touch screen
};

}  // namespace vantage
