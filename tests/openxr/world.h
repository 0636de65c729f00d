#pragma once
// The simulated state of the headset and the controllers, updated frame by frame from the scenario.
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/openxr/scenario.h"

namespace test_runtime {

struct Hand {
    bool active = false;
    XrPosef aim, grip;  ///< poses in the stage
    std::map<std::string, Input> inputs;
};

/// Left and right.
using Hands = std::array<Hand, 2>;

struct Moment {
    XrTime time;
    XrPosef head;
    Hands hands;
    bool untracked;
};

/// The origin of the local space, in the stage.
struct Origin {
    XrTime since;
    XrPosef pose;
};

struct World {
    Scenario scenario;
    int frame = 0;
    XrTime display_time;
    XrDuration period;
    bool should_render = true;
    std::optional<std::string> profile;
    Moment now;
    std::deque<Moment> moments;  ///< the latest frames; a program may still query the previous one
    std::vector<Origin> local_origins;
    std::vector<ForcedResult> forced;
};

/// The global state.
World& world();

/// Starts the clock with a session, so that earlier frames do not count as missed in real time.
void start_clock();
/// Advances to the next frame and its time. Returns the number of skipped periods.
int go_to_next_frame();
/// Applies the scenario's entries for the current frame.
void play_frame();

/// The state at a time, as known from the frames so far.
const Moment& moment_at(XrTime time);
XrPosef local_origin_at(XrTime time);

/// The current time on the clock of display times, in nanoseconds. In real time, that is the computer's
/// clock.
XrTime current_time();

/// The result that the scenario forces for this call, if any. Counts the use.
std::optional<XrResult> take_forced_result(const std::string& call);

}  // namespace test_runtime
