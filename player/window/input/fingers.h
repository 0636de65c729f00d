#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "player/window/input/pointer.h"

namespace vantage {

/// An event of a finger on the touch screen.
struct TouchEvent {
    enum class What { begin, move, end } what;
    std::uint32_t finger;  ///< number of the finger, constant from begin to end
    double x, y;           ///< pixels from the window's upper left corner
};

/// The fingers on the window. A single finger acts as the left mouse button. A second finger starts a pinch;
/// afterward, all fingers must be lifted before a finger acts as the button again.
class Fingers {
  public:
    /// `text_scale`: the window's text scale; the size of a finger in pixels is proportional to it. `now` and
    /// `late`: seconds, see Pointer.
    void take(const TouchEvent& event, double text_scale, double now, double late, UserInput& input);
    /// Adds the input for the next frame: the pinch, the drag and the pointer. A touch shorter than a frame
    /// is reported as a press in one frame and a release in the next.
    void report(UserInput& input);
    /// Whether there is input for further frames even without new events.
    bool unreported() const { return !to_show_.empty(); }
    /// Records that the mouse is in use again.
    void leave_to_mouse() { last_used_ = false; }

  private:
    struct Finger {
        std::uint32_t id;
        Eigen::Vector2d at;
    };
    void begin(const TouchEvent& event, double now, UserInput& input);
    void move_to(Finger& finger, const Eigen::Vector2d& at);
    void drag_to(const Eigen::Vector2d& at);
    void end(std::uint32_t finger, UserInput& input);
    bool pinches() const { return !acts_ && down_.size() >= 2; }
    PointerState pointer(bool down, bool there) const {
        return {pointer_.x, pointer_.y, {down, false, false}, there};
    }

    std::vector<Finger> down_;  ///< in the order in which they touched the screen
    Pointer pointer_;           ///< the pointer of the first finger
    bool acts_ = false;         ///< a finger acts as the left button
    bool drags_ = false;        ///< the finger has moved away from its start
    struct Shown {
        PointerState pointer;
        bool begins = false;  ///< the finger has just touched
    };
    std::deque<Shown> to_show_;   ///< queued for the next frames
    UserInput moved_;             ///< since the last report
    std::optional<Pinch> pinch_;  ///< since the last report
    bool begins_ = false;         ///< pinching began since the last report
    bool turns_ = false;          ///< the pinch also turns
    double twist_ = 0;            ///< accumulated rotation in radians, until the pinch turns
    bool last_used_ = false;      ///< the last input came from fingers, not from the mouse
};

}  // namespace vantage
