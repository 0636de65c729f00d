#pragma once
#include <array>
#include <optional>
#include <vector>

#include "player/view/pinch.h"

namespace vantage {

/// A key that was pressed.
struct KeyPress {
    int key;    ///< GLFW's code; of a letter, where the keyboard's layout has it
    int place;  ///< GLFW's code of the key's place on a US keyboard
    enum class With { nothing, control, other } with = With::nothing;  ///< other: also Alt or Super
    bool repeated = false;                                             ///< because it was held
};

/// How far the pointer moved while a mouse button was down, in pixels.
struct Drag {
    double right = 0, down = 0;
};
using Drags = std::array<Drag, 3>;  ///< by button: left, right, middle

/// The left mouse button, pressed and released again in one place.
struct Click {
    double x, y;  ///< pixels from the window's upper left corner
    bool second;  ///< of a double click
};

/// Where the pointer is for a frame: the mouse as it was when a button was pressed or released; a finger that
/// acts as the left button; the middle between two that pinch.
struct PointerState {
    double x, y;               ///< pixels from the window's upper left corner
    std::array<bool, 3> down;  ///< buttons: left, right, middle
    bool there = true;         ///< else it was lifted, and points at nothing
};

/// What was done with keys, mouse and fingers since the last frame.
struct UserInput {
    std::vector<KeyPress> keys;   ///< in order, also those that were released again
    std::vector<int> held;        ///< the places of keys that are down
    bool double_clicked = false;  ///< by the left button
    std::vector<Click> clicks;    ///< in order
    Drags drags{};
    std::optional<PointerState> pointer;  ///< if not where the mouse is by now
    std::optional<Pinch> pinch;           ///< while two fingers are down
    bool pinch_begins = false;
};

/// Whether a key was pressed, or repeated, alone since the last frame; takes the press.
bool take_key(UserInput& input, int key);

}  // namespace vantage
