#pragma once
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "player/camera/shots.h"
#include "player/window/fingers.h"
#include "player/window/pointer.h"
#include "player/window/touch_screen.h"
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
    /// Covers the whole screen, or is a window again, where it was.
    void fill_screen(bool whole);
    /// The scale of text that suits the display, 1 for 14 pixels.
    float fitting_text_scale() const;
    void set_text_scale(float scale);
    /// Handles what has happened. `seconds`: waits so long for something to happen; 0: does not wait.
    WindowEvents events(double seconds = 0);

  private:
    struct Callbacks;
    void watch_events();
    void watch_mouse();
    void take_touches();
    void report_mouse();

    GLFWwindow* window_ = nullptr;
    float text_scale_ = 1;
    struct Place {
        int x, y, width, height;
    };
    std::optional<Place> windowed_;  ///< while it covers the screen: where it was
    WindowEvents events_;
    std::vector<int> held_;  ///< places of keys
    double looked_at_ = 0;   ///< for events, seconds
    Pointer mouse_;
    struct MouseFrame {
        PointerState state;
        bool press;  ///< a button has just been pressed
    };
    std::deque<MouseFrame> mouse_frames_;  ///< by frames to come: one may be longer than a click
    UserInput moved_;                      ///< drags that are not reported yet
    Fingers fingers_;
    std::optional<TouchScreen> touch_screen_;
};

}  // namespace vantage
