#include "player/window/input/window_input.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace vantage {

void WindowInput::key(const KeyPress& p, bool down) {
    constexpr int unknown = -1;  // keys without a code may never be released
    note();
    if (!p.repeated) std::erase(held_, p.place);
    if (!down) return;
    if (!p.repeated && p.place != unknown) held_.push_back(p.place);
    events_.input.keys.push_back(p);
}

void WindowInput::button(std::size_t button, bool down, double now) {
    note();
    fingers_.leave_to_mouse();
    Pointer& m = mouse_;
    const auto show = [&](bool pressed) { mouse_frames_.push_back({{m.x, m.y, m.down}, pressed}); };
    if (down) {
        press(m, button, now, events_.input);
        return show(true);
    }
    if (std::hypot(m.x - m.last.x, m.y - m.last.y) > m.click_reach) show(false);  // dragged points follow
    release(m, button, events_.input);
    show(false);
}

void WindowInput::move_mouse(double x, double y) {
    note();
    fingers_.leave_to_mouse();
    move(mouse_, x, y, moved_);
}

void WindowInput::drop(std::vector<std::string> files) {
    note();
    std::ranges::move(files, std::back_inserter(events_.dropped));
}

void WindowInput::touch(const TouchEvent& event, double text_scale, double now) {
    note();
    fingers_.take(event, text_scale, now, mouse_.late, events_.input);
}

WindowEvents WindowInput::take(double now) {
    events_.any |= fingers_.unreported();
    fingers_.report(events_.input);
    report_mouse();
    looked_at_ = now;
    events_.input.held = held_;
    return std::exchange(events_, {});
}

/// The position of the press is reported first, then the drag from that position.
void WindowInput::report_mouse() {
    UserInput& input = events_.input;
    bool pressed = false;
    if (!mouse_frames_.empty()) {
        input.pointer = mouse_frames_.front().state;
        pressed = mouse_frames_.front().press;
        mouse_frames_.pop_front();
    }
    events_.any |= pressed || !mouse_frames_.empty();
    if (pressed) return;
    for (std::size_t b = 0; b < input.drags.size(); ++b) {
        input.drags[b].right += moved_.drags[b].right;
        input.drags[b].down += moved_.drags[b].down;
    }
    moved_ = {};
}

}  // namespace vantage
