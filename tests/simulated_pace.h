#pragma once
#include <algorithm>
#include <deque>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "player/render/timing/pace.h"

namespace vantage {

/// A renderer whose frame times have a fixed part and a part proportional to the number of pixels and photos.
struct Machine {
    double fixed, full;  ///< ms; `full` is the time at full size with all photos
    double time(const Pace& p) const { return fixed + full * p.scale * p.scale * (p.reduced ? 0.4 : 1); }
};

/// The conditions under which the frames of a motion are paced.
struct PacedMotion {
    Machine machine;
    double goal_ms;
    int delay = 0;  ///< number of additional frames before a frame's time is known
    std::function<double(int frame)> load =
        {};               ///< factor by which each frame's time is multiplied; 1 if empty
    double noise = 0.04;  ///< relative standard deviation of a frame's time
    int frames = 1000;
};

struct PacedFrame {
    Pace pace;
    double ms;
    bool missed;
};

/// Draws nothing: computes the time of each frame, and paces the following frames accordingly.
inline std::vector<PacedFrame> paced(const PacedMotion& m) {
    std::mt19937 engine(3);
    std::normal_distribution<double> normal;
    Pacing pacing;
    std::deque<std::pair<Pace, double>> unknown;
    std::vector<PacedFrame> out;
    for (int i = 0; i < m.frames; ++i) {
        const double ms = m.machine.time(pacing.pace) * (m.load ? m.load(i) : 1) *
                          std::max(0.1, 1 + m.noise * normal(engine));
        out.push_back({pacing.pace, ms, ms > m.goal_ms});
        unknown.emplace_back(pacing.pace, ms);
        if (int(unknown.size()) <= m.delay) continue;
        pacing = next_pacing(pacing, unknown.front().first, unknown.front().second, m.goal_ms);
        unknown.pop_front();
    }
    return out;
}

/// Loads for PacedMotion: 300 frames that take 2.5 times as long; one frame in 150 that takes 4 times as
/// long; a slow rise to 3 times as long and back.
inline double step_load(int i) { return i >= 200 && i < 500 ? 2.5 : 1.0; }
inline double spike_load(int i) { return i % 150 == 149 ? 4.0 : 1.0; }
inline double drift_load(int i) {
    return 1 + 2 * std::clamp(i < 500 ? (i - 100) / 400.0 : (900 - i) / 400.0, 0.0, 1.0);
}

/// The number of missed frames, starting with frame `first`.
inline std::size_t count_missed(const std::vector<PacedFrame>& frames, std::size_t first = 0) {
    return std::size_t(std::count_if(frames.begin() + std::ptrdiff_t(first), frames.end(),
                                     [](auto& f) { return f.missed; }));
}
/// The number of changes of pace, starting with frame `first`.
inline std::size_t count_changes(const std::vector<PacedFrame>& frames, std::size_t first = 1) {
    std::size_t changes = 0;
    for (std::size_t i = first; i < frames.size(); ++i) changes += frames[i].pace != frames[i - 1].pace;
    return changes;
}

/// The longest run of consecutive missed frames, starting with frame `first`.
inline int longest_missed(const std::vector<PacedFrame>& frames, std::size_t first = 0) {
    int longest = 0, now = 0;
    for (std::size_t i = first; i < frames.size(); ++i) {
        now = frames[i].missed ? now + 1 : 0;
        longest = std::max(longest, now);
    }
    return longest;
}

}  // namespace vantage
