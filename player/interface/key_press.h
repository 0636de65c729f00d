#pragma once

namespace vantage {

/// A key that was pressed.
struct KeyPress {
    int key;        ///< GLFW's code
    bool modified;  ///< with Ctrl, Alt or Super
};

}  // namespace vantage
