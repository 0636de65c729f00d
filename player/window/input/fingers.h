#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "player/window/input/pointer.h"

namespace vantage {

/// What a finger did on the screen.
struct TouchEvent {
    enum class What { begin, move, end } what;
    std::uint32_t finger;  ///< the same from begin to end
    double x, y;           ///< pixels from the window's upper left corner
};

/// The fingers on the window. One acts as the left mouse button; a second one makes it a pinch, and until all
/// are lifted, none acts as the button again.
class Fingers {
  public:
    /// `text_scale`: of the window; a finger covers as many pixels as it does letters. `now` and `late`:
    /// seconds, see Pointer.
    void take(const TouchEvent& event, double text_scale, double now, double late, UserInput& input);
    /// What the next frame is to know: what two fingers did, how far one dragged, and where the pointer is. A
    /// finger that was quicker than a frame is shown where it came down first, then where it was lifted.
    void report(UserInput& input);
    /// Whether the next frames are to know something else, even if nothing happens.
    bool unreported() const { return !to_show_.empty(); }
    /// The mouse was used instead.
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

    std::vector<Finger> down_;  ///< in the order in which they came
    Pointer pointer_;           ///< of the first one
    bool acts_ = false;         ///< it acts as the left button
    bool drags_ = false;        ///< and has left the place where it came down
    struct Shown {
        PointerState pointer;
        bool begins = false;  ///< the finger has just come down
    };
    std::deque<Shown> to_show_;   ///< by frames to come
    UserInput moved_;             ///< since the last report
    std::optional<Pinch> pinch_;  ///< since the last report
    bool begins_ = false;         ///< pinching began since the last report
    bool turns_ = false;          ///< the pinch also turns
    double twist_ = 0;            ///< radians, before it turns
    bool last_used_ = false;      ///< and not the mouse
};

}  // namespace vantage
