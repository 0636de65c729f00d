#pragma once
#include <vector>

#include "player/render/render_settings.h"
#include "player/render/timing/frame_statistics.h"
#include "player/render/timing/pace.h"

namespace vantage {

/// Statistics of the drawn frames.
struct DrawnFrames {
    FrameReport report;                                     ///< report of the last frame
    Pace pace;                                              ///< likewise
    std::vector<float> ms = std::vector<float>(240, 0.0f);  ///< durations of the last 240 frames, newest last
    FrameStatistics statistics;                             ///< of these
};

/// Records the duration of a frame, in milliseconds.
void note_time(DrawnFrames& frames, double ms);

}  // namespace vantage
