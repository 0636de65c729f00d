#pragma once
// Where things are and what they do, as the scenario tells, frame by frame.
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
    XrPosef aim, grip;  ///< in the stage
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

/// Of the local space, in the stage.
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
    std::deque<Moment> moments;  ///< the latest frames; a program may still ask for the one before
    std::vector<Origin> local_origins;
    std::vector<ForcedResult> forced;
};

/// Of the process.
World& world();

/// In real time, the frames before a session were not missed.
void start_clock();
/// Goes to the next frame and its time. Returns the number of periods skipped.
int go_to_next_frame();
/// What the scenario has for the frame where the world is.
void play_frame();

/// What the world is, at that time, by the frames so far.
const Moment& moment_at(XrTime time);
XrPosef local_origin_at(XrTime time);

/// Nanoseconds of the clock that display times are in. In real time, of the computer.
XrTime current_time();

/// What the scenario says that this call returns, and that it has done so once more.
std::optional<XrResult> take_forced_result(const std::string& call);

}  // namespace test_runtime
