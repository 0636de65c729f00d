#pragma once
#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include "base/gl/object.h"

namespace vantage {

/// The timed parts of drawing a frame.
enum class TimedPass { surface, photos, background, points, transparent, resolve, show };
inline constexpr std::array<const char*, 7> timed_pass_names{"surface",     "photos",  "background", "points",
                                                             "transparent", "resolve", "show"};
/// Milliseconds by pass.
using PassTimes = std::array<double, timed_pass_names.size()>;

/// Adds up the GPU time of each pass from timestamps, without waiting. Must be used on the OpenGL thread.
class PassClock {
  public:
    /// Starts timing.
    void start();
    /// Begins a pass and ends the previous one.
    void begin(TimedPass pass) { mark(std::size_t(pass)); }
    /// Ends the pass; the time that follows is not counted.
    void end() { mark(timed_pass_names.size()); }
    /// Times since start(); stops timing. Waits for the graphics card.
    PassTimes finish();

  private:
    struct Mark {
        gl::Query query;
        std::size_t pass;  ///< the pass that begins
    };
    void mark(std::size_t pass);
    void take(bool wait);
    void add(std::size_t next, double ms);

    bool on_ = false;
    std::deque<Mark> marks_;  ///< the graphics card may not have reached them yet
    std::vector<gl::Query> unused_;
    std::size_t pass_ = timed_pass_names.size();  ///< pass of the last mark reached
    double since_ = 0;                            ///< ms
    PassTimes ms_{};
};

}  // namespace vantage
