#pragma once

namespace vantage {

/// A key that was pressed.
struct KeyPress {
    int key;                                                           ///< GLFW's code
    enum class With { nothing, control, other } with = With::nothing;  ///< other: also Alt or Super
    bool repeated = false;                                             ///< because it was held
};

}  // namespace vantage
