#pragma once
#include <array>

#include "player/interface/state/user_input.h"

namespace vantage {

/// The mouse pointer, or the finger that acts as one: makes drags, clicks and double clicks of its movements.
struct Pointer {
    double x = 0, y = 0;         ///< pixels from the window's upper left corner
    std::array<bool, 3> down{};  ///< buttons: left, right, middle
    double click_reach = 5;      ///< pixels from where it was pressed that it may be released for a click
    double second_reach = 5;     ///< pixels between the clicks of a double click
    double late = 0;             ///< seconds by which events may be noticed late: those of a frame
    struct Press {
        double at = -1e9, x = -1e9, y = -1e9;  ///< seconds, pixels
        bool second = false;                   ///< of a double click
    };
    Press last;  ///< of the left button
};

/// ImGui only knows whether a button is down when a frame begins; these are noted as they happen.
void move(Pointer& pointer, double x, double y, UserInput& input);
/// `button`: 0 to 2, as in Pointer::down; others do nothing. `now`: seconds.
void press(Pointer& pointer, std::size_t button, double now, UserInput& input);
void release(Pointer& pointer, std::size_t button, UserInput& input);

}  // namespace vantage
