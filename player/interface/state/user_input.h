#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "player/view/pinch.h"

namespace vantage {

/// A key press.
struct KeyPress {
    int key;    ///< GLFW code; for letters, according to the keyboard layout
    int place;  ///< GLFW code of the key's position on a US keyboard
    enum class With { nothing, control, other } with = With::nothing;  ///< other: with Alt or Super
    bool repeated = false;                                             ///< key repeat while held
    bool shift = false;
};

/// Movement of the pointer while a mouse button was down, in pixels.
struct Drag {
    double right = 0, down = 0;
};
using Drags = std::array<Drag, 3>;  ///< one per button: left, right, middle

/// A click of the left mouse button without movement.
struct Click {
    double x, y;  ///< pixels from the window's upper left corner
    bool second;  ///< the second click of a double click
};

/// The pointer of a frame: the mouse at the time of a button event; a finger that acts as the left button; or
/// the midpoint of a pinch.
struct PointerState {
    double x, y;               ///< pixels from the window's upper left corner
    std::array<bool, 3> down;  ///< buttons: left, right, middle
    bool there = true;         ///< false: the finger was lifted, and there is no pointer
};

/// Keyboard, mouse and touch input since the last frame.
struct UserInput {
    std::vector<KeyPress> keys;   ///< key presses in order, even if the key has been released since
    std::vector<int> held;        ///< positions of the keys that are down
    bool double_clicked = false;  ///< a double click of the left button
    std::vector<Click> clicks;    ///< in order
    Drags drags{};
    std::optional<PointerState> pointer;  ///< set if it differs from the current mouse position
    std::optional<Pinch> pinch;           ///< set while two fingers touch the screen
    bool pinch_begins = false;
};

/// The pixel of the first click in the picture; nullopt if the pointer is over a panel.
std::optional<Eigen::Vector2d> clicked_pixel(const UserInput& input);

/// Whether a key was pressed or repeated without modifiers since the last frame. Removes the press from the
/// input.
bool take_key(UserInput& input, int key);

}  // namespace vantage
