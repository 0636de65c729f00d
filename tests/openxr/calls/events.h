#pragma once
#include "tests/openxr/calls/handles.h"
#include "tests/openxr/world.h"

namespace test_runtime {

/// Queues an event for xrPollEvent.
template <class EventData>
void send(Instance& instance, const EventData& event) {
    static_assert(sizeof(EventData) <= sizeof(XrEventDataBuffer));
    XrEventDataBuffer buffer{};
    std::copy_n(reinterpret_cast<const char*>(&event), sizeof event, reinterpret_cast<char*>(&buffer));
    instance.events.push_back(buffer);
}

/// Changes the state of a session and notifies the program.
void set_state(XrSession handle, XrSessionState state);
/// Takes a running session to `state`, through all states in between.
void walk_to(XrSession handle, XrSessionState state);

/// Carries out an event of the scenario in the current frame.
void happen(World& world, const Event& event);

/// Writes a line to events.txt.
void note(const std::string& what);

}  // namespace test_runtime
