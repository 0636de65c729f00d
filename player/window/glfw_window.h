#pragma once
#include <optional>
#include <string>

#include "player/view/shots.h"
#include "player/window/input/touch_screen.h"
#include "player/window/input/window_input.h"

struct GLFWwindow;

namespace vantage {

/// A GLFW window with an OpenGL 4.5 context, current on this thread, and ImGui.
class GlfwWindow {
  public:
    /// `debug`: creates a debug context. Throws Error(graphics).
    GlfwWindow(FrameSize size, const std::string& title, bool debug);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;
    GLFWwindow* get() const { return window_; }
    /// Switches between full screen and a window at its previous position.
    void fill_screen(bool whole);
    /// The text scale for the display; 1 means text of 14 pixels.
    float fitting_text_scale() const;
    void set_text_scale(float scale);
    /// Handles events. `seconds`: the maximum waiting time for an event; with 0, does not wait.
    WindowEvents events(double seconds = 0);

  private:
    struct Callbacks;
    void watch_events();
    void watch_mouse();

    GLFWwindow* window_ = nullptr;
    float text_scale_ = 1;
    struct Place {
        int x, y, width, height;
    };
    std::optional<Place> windowed_;  ///< the window's previous position, while in full screen
    WindowInput input_;
    std::optional<TouchScreen> touch_screen_;
};

}  // namespace vantage
