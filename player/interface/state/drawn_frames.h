#pragma once
#include <vector>

#include "player/render/render_settings.h"
#include "player/render/timing/frame_statistics.h"
#include "player/render/timing/pace.h"

namespace vantage {

/// How the frames were drawn.
struct DrawnFrames {
    FrameReport report;                                     ///< of the last one
    Pace pace;                                              ///< likewise
    std::vector<float> ms = std::vector<float>(240, 0.0f);  ///< of the last 240, milliseconds, newest last
    FrameStatistics statistics;                             ///< of these
};

/// Remembers how long a frame took, in milliseconds.
void note_time(DrawnFrames& frames, double ms);

}  // namespace vantage
