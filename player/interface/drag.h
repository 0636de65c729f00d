#pragma once

namespace vantage {

/// How far the pointer moved while a mouse button was down, in pixels.
struct Drag {
    double right = 0, down = 0;
};

}  // namespace vantage
