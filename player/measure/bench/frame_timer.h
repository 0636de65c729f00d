#pragma once
#include <chrono>

#include "base/gl/object.h"

namespace vantage {

/// Measures a frame's duration in milliseconds: on a graphics card, the longer of CPU time and GPU time (by a
/// timer query); with a software renderer, the time until glFinish() returns.
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
