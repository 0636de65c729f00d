#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

#include "base/gl/object.h"
#include "player/render/timing/pace.h"

namespace vantage {

/// Measures frames without waiting for the graphics card: the longer of the time on the processor and on the
/// graphics card (by timer queries), known some frames later. With a software renderer, which draws when it
/// is asked to finish, the time until it has. Belongs to the OpenGL thread.
class FrameClock {
  public:
    /// A frame that has been drawn.
    struct Frame {
        Pace pace;
        double ms;
    };

    explicit FrameClock(bool software);
    /// Begins a frame; one that did not end, because of an error, is not measured.
    void begin();
    /// Ends the frame, which was drawn at `pace`; nothing: not to be measured.
    void end(std::optional<Pace> pace);
    /// The newest measured frame known to be finished since the last call.
    std::optional<Frame> take();

  private:
    struct Timed {
        gl::Query query;
        std::optional<Pace> pace;
        double ms = 0;  ///< on the processor
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
