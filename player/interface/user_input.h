#pragma once
#include <array>
#include <optional>
#include <vector>

#include "player/camera/pinch.h"

namespace vantage {

/// A key that was pressed.
struct KeyPress {
    int key;                                                           ///< GLFW's code
    enum class With { nothing, control, other } with = With::nothing;  ///< other: also Alt or Super
    bool repeated = false;                                             ///< because it was held
};

/// How far the pointer moved while a mouse button was down, in pixels.
struct Drag {
    double right = 0, down = 0;
};

/// The left mouse button, pressed and released again in one place.
struct Click {
    double x, y;  ///< pixels from the window's upper left corner
    bool second;  ///< of a double click
};

/// A finger on the screen that acts as the pointer with its left button, or the middle between two that
/// pinch.
struct FingerPointer {
    double x, y;  ///< pixels from the window's upper left corner
    bool down;
    bool there;  ///< else it was lifted, and points at nothing
};

/// What was done with keys, mouse and fingers since the last frame.
struct UserInput {
    std::vector<KeyPress> keys;           ///< in order, also those that were released again
    bool double_clicked = false;          ///< by the left button
    std::vector<Click> clicks;            ///< in order
    std::array<Drag, 3> drags{};          ///< by button: left, right, middle
    std::optional<FingerPointer> finger;  ///< if fingers were used last, and not the mouse
    std::optional<Pinch> pinch;           ///< while two fingers are down
    bool pinch_begins = false;
};

}  // namespace vantage
