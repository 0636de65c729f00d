#pragma once
#include <memory>
#include <vector>

#include "player/window/input/fingers.h"

struct GLFWwindow;

namespace vantage {

/// The touch screen under a window. GLFW only reports the first finger, as a mouse. Touch events need X11
/// with XInput 2.2. Otherwise there are none, and the first finger acts as a mouse.
class TouchScreen {
  public:
    /// Listens on a separate thread, which wakes the window's thread when that thread waits for events.
    explicit TouchScreen(GLFWwindow* window);
    ~TouchScreen();
    TouchScreen(const TouchScreen&) = delete;
    TouchScreen& operator=(const TouchScreen&) = delete;
    /// The events since the last call, in order.
    std::vector<TouchEvent> take();

  private:
    struct Listener;
    std::unique_ptr<Listener> listener_;  ///< empty if there is no touch screen
};

}  // namespace vantage
