#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

#include "base/gl/object.h"
#include "player/render/timing/pace.h"

namespace vantage {

/// Measures frame times without waiting for the graphics card: the longer of CPU time and GPU time (from
/// timer queries), available a few frames later. With a software renderer, which draws during glFinish(),
/// measures the time until that call returns. Must be used on the OpenGL thread.
class FrameClock {
  public:
    /// A frame that has been drawn.
    struct Frame {
        Pace pace;
        double ms;
    };

    explicit FrameClock(bool software);
    /// Begins a frame. A frame that an error left unfinished is not measured.
    void begin();
    /// Ends the frame, which was drawn at `pace`; nullopt discards the measurement.
    void end(std::optional<Pace> pace);
    /// The newest measured frame that has finished since the last call.
    std::optional<Frame> take();

  private:
    struct Timed {
        gl::Query query;
        std::optional<Pace> pace;
        double ms = 0;  ///< CPU time
        bool pending = false;
    };
    bool software_;
    std::array<Timed, 4> ring_;
    std::size_t next_ = 0;
    bool measuring_ = false;
    std::chrono::steady_clock::time_point start_;
    std::optional<Frame> last_;
};

}  // namespace vantage
