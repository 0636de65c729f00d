#pragma once
#include <chrono>

#include "gl/object.h"

namespace vantage {

/// Milliseconds of a frame. On a graphics card the longer of the CPU's time and the card's (by a timer
/// query); on a software renderer the time until it has finished.
class FrameTimer {
  public:
    explicit FrameTimer(bool software);
    void begin();
    double end();

  private:
    bool software_;
    gl::Query query_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace vantage
