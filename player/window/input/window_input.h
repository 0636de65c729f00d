#pragma once
#include <deque>
#include <string>
#include <vector>

#include "player/window/input/fingers.h"
#include "player/window/input/pointer.h"
#include "player/window/input/window_events.h"

namespace vantage {

/// What is done with a window's keys, mouse and fingers, collected for its frames.
class WindowInput {
  public:
    /// Something has happened that only a frame shows: text, a turn of the wheel, another size, the focus.
    void note() { events_.any = true; }
    /// A key went down, was repeated, or came up.
    void key(const KeyPress& press, bool down);
    /// `now`: seconds, as below; `button`: as in Pointer::down.
    void button(std::size_t button, bool down, double now);
    void move_mouse(double x, double y);
    /// Where the mouse is, before it has moved.
    void set_mouse(double x, double y) { mouse_.x = x, mouse_.y = y; }
    void drop(std::vector<std::string> files);
    /// `text_scale`: of the window.
    void touch(const TouchEvent& event, double text_scale, double now);

    /// Events from now on were not looked for since the last frame.
    void look(double now) { mouse_.late = now - looked_at_; }
    /// What the next frame is to know.
    WindowEvents take(double now);

  private:
    void report_mouse();

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
};

}  // namespace vantage
