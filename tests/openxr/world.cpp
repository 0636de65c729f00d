#include "tests/openxr/world.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/openxr/calls/events.h"

namespace test_runtime {
namespace {

Hand resting_hand(float x) {
    return {false, {{0, 0, 0, 1}, {x, 1.2f, -.3f}}, {{0, 0, 0, 1}, {x, 1.2f, -.3f}}, {}};
}

XrDuration period_of(double hertz) { return std::llround(1e9 / hertz); }

XrTime real_time() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

void move(Hand& hand, const HandEntry& entry) {
    hand.active = entry.active.value_or(true);
    hand.aim = entry.aim.value_or(hand.aim);
    hand.grip = entry.grip.value_or(hand.grip);
    for (const auto& [path, value] : entry.inputs) hand.inputs[path] = value;
}

void move(World& world) {
    for (const HeadEntry& entry : world.scenario.head)
        if (entry.frame == world.frame) world.now.head = entry.pose;
    for (const HandEntry& entry : world.scenario.hands)
        if (entry.frame == world.frame) move(world.now.hands[entry.hand], entry);
}

void play_events(World& world) {
    for (const Event& event : world.scenario.events)
        if (event.frame == world.frame) happen(world, event);
    if (world.scenario.end == world.frame)
        happen(world, {world.frame, StateChange{XR_SESSION_STATE_STOPPING, false}});
}

World beginning() {
    World out{};
    out.scenario = read_scenario();
    out.period = period_of(out.scenario.rate);
    out.display_time = out.scenario.real_time ? real_time() : 1'000'000'000;
    out.profile = out.scenario.profile;
    out.forced = out.scenario.forced;
    out.now = {out.display_time, identity_pose, {resting_hand(-.2f), resting_hand(.2f)}, false};
    move(out);
    out.local_origins = {{0, levelled(out.now.head)}};
    play_events(out);
    out.moments = {out.now};
    return out;
}

/// The number of periods by which this frame is late, according to the scenario and the clock.
int periods_skipped(World& world) {
    int skipped = 0;
    for (const Event& event : world.scenario.events) {
        if (event.frame != world.frame) continue;
        if (const auto* delay = std::get_if<Delay>(&event.what)) skipped += delay->periods;
        if (const auto* rate = std::get_if<Rate>(&event.what)) world.period = period_of(rate->hertz);
    }
    if (world.scenario.real_time)
        skipped += int(std::max(XrTime(0), (real_time() - world.display_time) / world.period));
    return skipped;
}

}  // namespace

World& world() {
    static World& all = *new World(beginning());
    return all;
}

void start_clock() {
    if (world().scenario.real_time) world().display_time = std::max(world().display_time, real_time());
}

int go_to_next_frame() {
    World& w = world();
    ++w.frame;
    const int skipped = periods_skipped(w);
    w.display_time += w.period * (1 + skipped);
    return skipped;
}

void play_frame() {
    World& w = world();
    move(w);
    play_events(w);
    w.now.time = w.display_time;
    w.moments.push_back(w.now);
    if (w.moments.size() > 8) w.moments.pop_front();
}

const Moment& moment_at(XrTime time) {
    const std::deque<Moment>& all = world().moments;
    const auto after = std::find_if(all.begin(), all.end(), [&](const Moment& m) { return m.time > time; });
    return after == all.begin() ? *after : *std::prev(after);
}

XrPosef local_origin_at(XrTime time) {
    XrPosef out = world().local_origins.front().pose;
    for (const Origin& origin : world().local_origins)
        if (origin.since <= time) out = origin.pose;
    return out;
}

XrTime current_time() { return world().scenario.real_time ? real_time() : world().display_time; }

std::optional<XrResult> take_forced_result(const std::string& call) {
    for (ForcedResult& forced : world().forced) {
        if (forced.call != call || forced.times == 0) continue;
        if (forced.times > 0) --forced.times;
        return forced.result;
    }
    return {};
}

}  // namespace test_runtime
