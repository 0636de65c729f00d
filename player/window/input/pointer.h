#pragma once
#include <array>

#include "player/interface/state/user_input.h"

namespace vantage {

/// The mouse pointer, or the finger that acts as one. Derives drags, clicks and double clicks from its
/// events.
struct Pointer {
    double x = 0, y = 0;         ///< pixels from the window's upper left corner
    std::array<bool, 3> down{};  ///< buttons: left, right, middle
    double click_reach = 5;      ///< maximum movement during a click, in pixels
    double second_reach = 5;     ///< maximum distance between the two clicks of a double click, in pixels
    double late = 0;             ///< maximum delay of events, in seconds: the duration of a frame
    struct Press {
        double at = -1e9, x = -1e9, y = -1e9;  ///< seconds, pixels
        bool second = false;                   ///< of a double click
    };
    Press last;  ///< of the left button
};

/// Handle events as they occur; ImGui samples buttons only at the beginning of a frame.
void move(Pointer& pointer, double x, double y, UserInput& input);
/// `button`: 0 to 2, as in Pointer::down; others are ignored. `now`: seconds.
void press(Pointer& pointer, std::size_t button, double now, UserInput& input);
void release(Pointer& pointer, std::size_t button, UserInput& input);

}  // namespace vantage
