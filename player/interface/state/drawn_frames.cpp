#include "player/interface/state/drawn_frames.h"

#include <algorithm>
#include <utility>

namespace vantage {

void note_time(DrawnFrames& frames, double ms) {
    std::rotate(frames.ms.begin(), frames.ms.begin() + 1, frames.ms.end());
    frames.ms.back() = float(ms);
    std::vector<double> drawn;
    for (const float t : frames.ms)
        if (t > 0) drawn.push_back(double(t));
    frames.statistics = frame_statistics(std::move(drawn));
}

}  // namespace vantage
