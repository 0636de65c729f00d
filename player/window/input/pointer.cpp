#include "player/window/input/pointer.h"

#include <cmath>

namespace vantage {

void move(Pointer& p, double x, double y, UserInput& input) {
    for (std::size_t b = 0; b < p.down.size(); ++b)
        if (p.down[b]) input.drags[b].right += x - p.x, input.drags[b].down += y - p.y;
    p.x = x;
    p.y = y;
}

// Double clicks are detected here: in a frame longer than two clicks, ImGui detects only one.
void press(Pointer& p, std::size_t button, double now, UserInput& input) {
    constexpr double max_seconds = 0.4;
    if (button >= p.down.size()) return;
    p.down[button] = true;
    if (button != 0) return;
    const bool second = !p.last.second &&
                        now - p.last.at <= max_seconds + p.late &&  // a third click starts a new one
                        std::hypot(p.x - p.last.x, p.y - p.last.y) <= p.second_reach;
    input.double_clicked |= second;
    p.last = {now, p.x, p.y, second};
}

void release(Pointer& p, std::size_t button, UserInput& input) {
    if (button >= p.down.size()) return;
    p.down[button] = false;
    if (button == 0 && std::hypot(p.x - p.last.x, p.y - p.last.y) <= p.click_reach)
        input.clicks.push_back({p.last.x, p.last.y, p.last.second});
}

}  // namespace vantage
