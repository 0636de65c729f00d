#include "tests/openxr/calls/events.h"

#include <openxr/openxr_reflection.h>

#include <array>

#include "tests/openxr/calls.h"
#include "tests/openxr/calls/record.h"

namespace test_runtime {
namespace {

/// The states of a running session, in order.
constexpr std::array way = {XR_SESSION_STATE_STOPPING, XR_SESSION_STATE_SYNCHRONIZED,
                            XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED};

std::ptrdiff_t place(XrSessionState state) { return std::find(way.begin(), way.end(), state) - way.begin(); }

std::string state_name(XrSessionState state) {
#define NAMED_STATE(name, value) \
    if (state == name) return std::string(#name).substr(sizeof "XR_SESSION_STATE_" - 1);
    XR_LIST_ENUM_XrSessionState(NAMED_STATE);
#undef NAMED_STATE
    return "?";
}

/// Carries out one event of the scenario. There is at most one instance and one session.
struct Happening {
    World& world;

    template <class Act>
    void each_session(Act act) const {
        for (auto& [handle, session] : handles().sessions)
            if (session.loss == Loss::none) act(handle, session);
    }

    void operator()(const StateChange& change) const {
        each_session([&](XrSession handle, Session& session) {
            session.ready_again = change.ready_again;
            if (session.running) walk_to(handle, change.to);
        });
    }
    void operator()(const Recenter& recenter) const {
        std::vector<Origin>& origins = world.local_origins;
        origins.push_back({world.display_time, composed(origins.back().pose, recenter.pose)});
        record_event(world.frame, "recentered");
        each_session([&](XrSession handle, Session& session) {
            send(instance_of(session.instance),
                 XrEventDataReferenceSpaceChangePending{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING,
                                                        nullptr, handle, XR_REFERENCE_SPACE_TYPE_LOCAL,
                                                        world.display_time, XR_TRUE, recenter.pose});
        });
    }
    void operator()(SessionLoss) const {
        each_session([&](XrSession handle, Session& session) {
            set_state(handle, XR_SESSION_STATE_LOSS_PENDING);
            session.loss = Loss::untold;
        });
    }
    void operator()(InstanceLoss loss) const {
        handles().unavailable = loss.unavailable;
        record_event(world.frame, "instance lost");
        for (auto& [handle, instance] : handles().instances) {
            send(instance, XrEventDataInstanceLossPending{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr,
                                                          world.display_time});
            instance.loss = Loss::untold;
        }
    }
    void operator()(Delay) const {}  // affects the time of the frame, which is set before its events
    void operator()(Rate) const {}
    void operator()(Rendering rendering) const { world.should_render = rendering.wanted; }
    void operator()(Tracking tracking) const { world.now.untracked = tracking.lost; }
    void operator()(EventsLost lost) const {
        for (auto& [handle, instance] : handles().instances)
            send(instance, XrEventDataEventsLost{XR_TYPE_EVENT_DATA_EVENTS_LOST, nullptr, lost.count});
    }
    void operator()(const ProfileChange& change) const { world.profile = change.profile; }
    void operator()(const ForcedResult& forced) const { world.forced.push_back(forced); }
};

}  // namespace

void set_state(XrSession handle, XrSessionState state) {
    Session& session = *handles().sessions.find(handle);
    session.state = state;
    note("session " + state_name(state));
    send(*handles().instances.find(session.instance),
         XrEventDataSessionStateChanged{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, handle, state,
                                        current_time()});
}

void walk_to(XrSession handle, XrSessionState state) {
    const Session& session = *handles().sessions.find(handle);
    // STOPPING is final, and READY can change directly to STOPPING.
    if (session.state == XR_SESSION_STATE_STOPPING) return;
    if (session.state == XR_SESSION_STATE_READY && state == XR_SESSION_STATE_STOPPING)
        return set_state(handle, state);
    if (session.state == XR_SESSION_STATE_READY) set_state(handle, XR_SESSION_STATE_SYNCHRONIZED);
    while (session.state != state) {
        const std::ptrdiff_t from = place(session.state), to = place(state);
        set_state(handle, way[std::size_t(from < to ? from + 1 : from - 1)]);
    }
}

void happen(World& world, const Event& event) { std::visit(Happening{world}, event.what); }

void note(const std::string& what) { record_event(world().frame, what); }

XrResult poll_event(XrInstance handle, XrEventDataBuffer* out) {
    // A lost instance must still report its loss.
    Instance& instance = live(handles().instances, handle);
    if (instance.events.empty()) instance_of(handle);
    check_struct(out, XR_TYPE_EVENT_DATA_BUFFER);
    if (instance.events.empty()) return XR_EVENT_UNAVAILABLE;
    *out = instance.events.front();
    instance.events.pop_front();
    return XR_SUCCESS;
}

}  // namespace test_runtime
