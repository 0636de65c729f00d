#pragma once
#include <array>
#include <string>

#include "player/camera/shots.h"
#include "player/window/window_events.h"

struct GLFWwindow;

namespace vantage {

/// A GLFW window with an OpenGL 4.5 context, current on this thread, and ImGui.
class GlfwWindow {
  public:
    /// `debug`: with a debug context. Throws Error(graphics).
    GlfwWindow(FrameSize size, const std::string& title, bool debug);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;
    GLFWwindow* get() const { return window_; }
    /// Handles what has happened. `seconds`: waits so long for something to happen; 0: does not wait.
    WindowEvents events(double seconds = 0);

  private:
    struct Callbacks;
    void watch_events();

    GLFWwindow* window_ = nullptr;
    WindowEvents events_;
    struct Click {
        double at = -1e9, x = 0, y = 0;  ///< seconds, pixels
    };
    Click clicked_;
    double x_ = 0, y_ = 0;        ///< of the pointer
    std::array<bool, 3> down_{};  ///< buttons: left, right, middle
};

}  // namespace vantage
