#pragma once
#include <string>

#include "player/camera/shots.h"

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

  private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace vantage
