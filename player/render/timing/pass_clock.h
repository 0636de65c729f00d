#pragma once
#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include "base/gl/object.h"

namespace vantage {

/// The parts of drawing a frame that are timed.
enum class TimedPass { surface, photos, background, points, transparent, resolve, show };
inline constexpr std::array<const char*, 7> timed_pass_names{"surface",     "photos",  "background", "points",
                                                             "transparent", "resolve", "show"};
/// Milliseconds by pass.
using PassTimes = std::array<double, timed_pass_names.size()>;

/// Sums up the time that each pass takes on the graphics card, by timestamps, without waiting for it. Belongs
/// to the OpenGL thread.
class PassClock {
  public:
    /// Nothing is timed before.
    void start();
    /// Begins a pass; the one before ends.
    void begin(TimedPass pass) { mark(std::size_t(pass)); }
    /// Ends the pass: others take the time that follows.
    void end() { mark(timed_pass_names.size()); }
    /// Since start(); nothing is timed from here on. Waits for the graphics card.
    PassTimes finish();

  private:
    struct Mark {
        gl::Query query;
        std::size_t pass;  ///< that begins
    };
    void mark(std::size_t pass);
    void take(bool wait);
    void add(std::size_t next, double ms);

    bool on_ = false;
    std::deque<Mark> marks_;  ///< that may not have been reached
    std::vector<gl::Query> unused_;
    std::size_t pass_ = timed_pass_names.size();  ///< of the last mark reached
    double since_ = 0;                            ///< ms
    PassTimes ms_{};
};

}  // namespace vantage
