#pragma once
#include <deque>
#include <string>
#include <vector>

#include "player/window/input/fingers.h"
#include "player/window/input/pointer.h"
#include "player/window/input/window_events.h"

namespace vantage {

/// A window's keyboard, mouse and touch input, collected for its frames.
class WindowInput {
  public:
    /// Records an event that requires a frame: text, wheel, size, focus.
    void note() { events_.any = true; }
    /// A key was pressed, repeated, or released.
    void key(const KeyPress& press, bool down);
    /// `now`: seconds, here and below; `button`: as in Pointer::down.
    void button(std::size_t button, bool down, double now);
    void move_mouse(double x, double y);
    /// Sets the position of the mouse before its first movement.
    void set_mouse(double x, double y) { mouse_.x = x, mouse_.y = y; }
    void drop(std::vector<std::string> files);
    /// `text_scale`: the window's text scale.
    void touch(const TouchEvent& event, double text_scale, double now);

    /// Starts handling events: the events that follow may have occurred at any time since the last frame.
    void look(double now) { mouse_.late = now - looked_at_; }
    /// The input for the next frame.
    WindowEvents take(double now);

  private:
    void report_mouse();

    WindowEvents events_;
    std::vector<int> held_;  ///< positions of keys
    double looked_at_ = 0;   ///< when events were last handled, seconds
    Pointer mouse_;
    struct MouseFrame {
        PointerState state;
        bool press;  ///< a button was just pressed
    };
    std::deque<MouseFrame> mouse_frames_;  ///< queued for the next frames: a frame may be longer than a click
    UserInput moved_;                      ///< drags that are not reported yet
    Fingers fingers_;
};

}  // namespace vantage
